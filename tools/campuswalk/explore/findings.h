#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

enum class FindingKind { unreached, trap, stuck, hole, narrow, trigger, popup, island, hot };

/// Something that an author of the campus would want to know.
struct Finding {
    FindingKind kind = FindingKind::island;
    std::string subject;                     ///< "place desk", "island"
    std::string text;                        ///< what is wrong, and why; one line without its full stop
    std::optional<collision::Vec3> at = {};  ///< none: it is nowhere, as a building that nothing belongs to
    std::optional<engine::Barrier> barrier = {};
    std::vector<std::size_t> islands = {};  ///< indices into WalkReport::islands; `barrier` is the first's
    std::string trigger = {};               ///< id, of one that reaches through a floor
    std::vector<FindingKind> also = {};     ///< what it is besides: `--fail-on` looks for these, too
    /// Of a trap, a stuck spot, a hole or the way into ground behind a narrow passage: which of the report's.
    std::optional<std::size_t> index = {};
    std::size_t count = 1;  ///< of like things that share it; `at` is the first's
};

/// Unreached subjects first, then traps (stuck spots if they are small), holes, narrow passages, triggers
/// that reach through a floor, pop-ups that nobody can open, islands and hot spots. Subjects on one island
/// are one finding, and islands of one kind are; tops of things, higher than anyone climbs, and hollows are
/// left out: see IslandGroup.
std::vector<Finding> find_findings(const scene::Campus& campus, const engine::WalkReport& report);

/// Why a subject isn't reached that has a reason, such as "other objects hide it".
std::string why_unreached(const engine::Subject& subject);

struct FindingName {
    FindingKind kind;
    const char* name;     ///< in files and in `--fail-on`
    const char* meaning;  ///< what `--fail-on` looks for
};

inline constexpr std::array<FindingName, 9> kFindingNames = {{
    {FindingKind::unreached, "unreached", "a spawn, a place, a building or an object that nobody gets to"},
    {FindingKind::trap, "traps", "ground that one gets to and not away from, of 1 m² or more"},
    {FindingKind::stuck, "stuck", "such a spot that is smaller"},
    {FindingKind::hole, "holes", "edges over which one falls out of the world"},
    {FindingKind::narrow, "narrow", "passages that are too narrow for --min-width"},
    {FindingKind::trigger, "triggers", "triggers that nobody can enter, or that reach through a floor"},
    {FindingKind::popup, "popups", "buildings' pop-ups that nobody can open"},
    {FindingKind::island, "islands", "other walkable ground that isn't reached, of more than 1 m²"},
    {FindingKind::hot, "hot", "spots with so many triangles around the visitor that ticks take long"},
}};

const char* name_of(FindingKind kind);

/// Whether the finding is of the kind of this name, or also of it.
bool is_of_kind(const Finding& finding, const std::string& name);

}  // namespace campuswalk::tools::explore
