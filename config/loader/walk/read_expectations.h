#pragma once

#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/walk/walk_names.h"
#include "engine/script/expectation.h"

namespace campuswalk::config {

/// Reads `expect` of a walk: a list of maps with one key each, or of words that need no value.
std::vector<engine::Expectation> read_expectations(const CheckedNode& section, const WalkNames& names);

/// Reads `expect` of a step: one, or a list. Those that can only be evaluated after the run are errors.
std::vector<engine::Expectation> read_step_expectations(const CheckedNode& node, const WalkNames& names);

}  // namespace campuswalk::config
