#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "engine/walkspace/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

enum class FindingKind { unreached, trap, stuck, hole, narrow, trigger, island, hot };

/// Something that an author of the campus would want to know.
struct Finding {
    FindingKind kind = FindingKind::island;
    std::string subject;  ///< "place desk", "island"
    std::string text;     ///< what is wrong, and why; one line without its full stop
    collision::Vec3 at = collision::Vec3::Zero();
    std::optional<engine::Barrier> barrier = {};
    std::optional<std::size_t> island = {};  ///< index into WalkReport::islands
    std::string trigger = {};                ///< id, of one that reaches through a floor
};

/// Unreached subjects first, then traps (stuck spots if they are small), holes, narrow passages, triggers
/// that reach through a floor, islands and hot spots. Subjects on one island are one finding; islands that
/// are the tops of things, higher than anyone climbs (is_top), are left out.
std::vector<Finding> find_findings(const scene::Campus& campus, const engine::WalkReport& report);

/// Roofs, the tops of walls and the like: islands that are only reached over a ledge.
bool is_top(const engine::IslandReport& island);

/// What it is called in files and in `--fail-on`: "unreached", "traps", "stuck", "holes", "narrow",
/// "triggers", "islands", "hot".
const char* name_of(FindingKind kind);

}  // namespace campuswalk::tools::explore
