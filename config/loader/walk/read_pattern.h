#pragma once

#include "config/loader/values/checked_node.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// `KIND OBJECT` or `KIND`; reports a kind that matches no event (unknown-name).
engine::EventPattern read_pattern(const CheckedNode& node);

}  // namespace campuswalk::config
