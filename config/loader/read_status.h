#pragma once

#include "config/loader/checked_node.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads `status`: run, skip, only or xfail, or a map with `is`, `because` and, of an xfail, `failures`.
engine::WalkStatus read_status(const CheckedNode& node);

/// Reads `tags`: a kebab-case word or a list of them, each once.
std::vector<std::string> read_tags(const CheckedNode& node);

}  // namespace campuswalk::config
