#include "tools/campuswalk/explore/start_names.h"

#include <algorithm>

namespace campuswalk::tools::explore {

std::string start_of(const scene::Campus& campus, const engine::WalkReport& report,
                     const engine::SubjectReport& entry) {
    const std::vector<scene::Spawn>& spawns = campus.description.spawns;
    if (!entry.distance || !entry.subject.node || spawns.empty()) {
        return "";
    }
    engine::WalkNodeId first = *entry.subject.node;
    while (const auto before = report.space.parent(first)) {
        first = *before;
    }
    // A spawn's body may have been put down a little beside it.
    const collision::Vec3 foot = report.space.position(first);
    return std::ranges::min_element(
               spawns, {}, [&](const scene::Spawn& spawn) { return (spawn.position - foot).squaredNorm(); })
        ->name;
}

}  // namespace campuswalk::tools::explore
