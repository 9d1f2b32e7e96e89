#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/walkspace/walk_report.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// A walk of the fewest steps that show a finding: it starts where a visitor gets to and tries what fails.
struct MinimalWalk {
    std::string name;  ///< of the file, without its ending: "01-unreached-desk"
    std::string yaml;
};

/// What the walks have in common.
struct WalkHeader {
    std::string campus;  ///< the campus file, from the walks' folder
    std::string avatar;  ///< as written after `avatar:`; as low as it crouches, if it may
    /// Of the visitor for whom passages are too narrow, likewise.
    std::string wide_avatar;
    double bottom = 0.0;  ///< the lowest height of the world, metres
};

/// A walk for each finding that one can be shown of by walking: none for what is inside an object. They are
/// xfail until the campus is mended, and pass from then on.
std::vector<MinimalWalk> minimal_walks(const engine::WalkReport& report, const std::vector<Finding>& findings,
                                       const WalkHeader& header);

}  // namespace campuswalk::tools::explore
