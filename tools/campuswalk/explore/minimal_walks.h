#pragma once

#include <string>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "tools/campuswalk/explore/findings.h"
#include "tools/campuswalk/explore/walk_draft.h"

namespace campuswalk::tools::explore {

/// A walk of the fewest steps that show a finding: it starts where a visitor gets to and tries what fails.
struct MinimalWalk {
    std::string name;  ///< of the file, without its ending: "01-unreached-desk"
    std::string yaml;
};

/// What the walks have in common.
struct WalkHeader {
    std::string campus;       ///< the campus file, from the walks' folder
    std::string avatar;       ///< as written after `avatar:`
    std::string wide_avatar;  ///< of the visitor for whom passages are too narrow, likewise
    std::string schema_line;  ///< see tools/campuswalk/base/schema_line.h
};

/// Who walks them, on the campus that the report is about.
struct WalkPlayers {
    const DraftPlayer& usual;  ///< as low as it crouches, if it may
    const DraftPlayer& wide;   ///< for whom passages are too narrow
    /// Those that the report's visitor takes.
    engine::Strider& strider;
};

/// A walk for each finding that one can be shown of by walking: none for what is inside an object. Each has
/// been played and fails, from ground on which a visitor walks towards what is wrong. They are xfail until
/// the campus is mended, and pass from then on.
std::vector<MinimalWalk> minimal_walks(const engine::WalkReport& report, const std::vector<Finding>& findings,
                                       const WalkHeader& header, const WalkPlayers& players);

}  // namespace campuswalk::tools::explore
