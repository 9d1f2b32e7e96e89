#pragma once

#include "config/loader/values/checked_node.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// `KIND OBJECT` or `KIND`; a kind that no event has is a typing mistake (unknown-name).
engine::EventPattern read_pattern(const CheckedNode& node);

}  // namespace campuswalk::config
