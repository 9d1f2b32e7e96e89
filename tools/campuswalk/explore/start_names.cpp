#include "tools/campuswalk/explore/start_names.h"

#include <algorithm>

namespace campuswalk::tools::explore {

std::string name_of_start(const scene::Campus& campus, const engine::WalkReport& report,
                          const engine::WalkNodeId& start) {
    const std::vector<scene::Spawn>& spawns = campus.description.spawns;
    // A spawn's body may have been put down a little beside it.
    const collision::Vec3 foot = report.space.position(start);
    const auto nearest = std::ranges::min_element(
        spawns, {}, [&](const scene::Spawn& spawn) { return (spawn.position - foot).squaredNorm(); });
    return nearest == spawns.end() ? "" : nearest->name;
}

std::string start_of(const scene::Campus& campus, const engine::WalkReport& report,
                     const engine::SubjectReport& entry) {
    if (!entry.distance || !entry.subject.node) {
        return "";
    }
    engine::WalkNodeId first = *entry.subject.node;
    while (const auto before = report.space.parent(first)) {
        first = *before;
    }
    return name_of_start(campus, report, first);
}

}  // namespace campuswalk::tools::explore
