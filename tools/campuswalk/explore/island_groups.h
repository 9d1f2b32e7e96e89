#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// Islands that are the same kind of thing, such as the tops of a library's tables: on objects or nodes whose
/// names differ by their numbers only, and with the same barrier before them.
struct IslandGroup {
    std::vector<std::size_t> islands;  ///< indices into WalkReport::islands, the largest first
    std::string on;                    ///< what they are on: "walls (table_07)", of several "walls (table_*)"
};

/// The group with the largest island first. Those in `told` are left out, and what is no finding: islands of
/// less than kNotableIsland, tops, hollows.
std::vector<IslandGroup> group_islands(const scene::Campus& campus, const engine::WalkReport& report,
                                       const std::set<std::size_t>& told);

/// Roofs, the tops of walls and the like: islands that are only reached over a ledge.
bool is_top(const engine::IslandReport& island);

}  // namespace campuswalk::tools::explore
