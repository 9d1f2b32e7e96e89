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
    std::vector<std::size_t> islands = {};  ///< indices into WalkReport::islands; `barrier` is the first's
    std::string trigger = {};               ///< id, of one that reaches through a floor
};

/// Unreached subjects first, then traps (stuck spots if they are small), holes, narrow passages, triggers
/// that reach through a floor, islands and hot spots. Subjects on one island are one finding, and islands of
/// one kind are; tops of things, higher than anyone climbs, and hollows are left out: see IslandGroup.
std::vector<Finding> find_findings(const scene::Campus& campus, const engine::WalkReport& report);

/// What it is called in files and in `--fail-on`: "unreached", "traps", "stuck", "holes", "narrow",
/// "triggers", "islands", "hot".
const char* name_of(FindingKind kind);

}  // namespace campuswalk::tools::explore
