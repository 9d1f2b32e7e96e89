#pragma once

#include <vector>

#include "config/loader/campus_names.h"
#include "config/loader/checked_node.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Reads `expect`: a list of maps with one key each.
std::vector<engine::Expectation> read_expectations(const CheckedNode& section, const CampusNames& names);

}  // namespace campuswalk::config
