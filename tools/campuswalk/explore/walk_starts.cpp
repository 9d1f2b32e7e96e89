#include "tools/campuswalk/explore/walk_starts.h"

#include <algorithm>

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::GroundState;
using engine::WalkNodeId;

WalkStarts::WalkStarts(const engine::WalkReport& report, engine::Strider& strider)
    : space_(report.space), strider_(strider) {
    for (const engine::Trap& trap : report.traps) {
        traps_.insert(trap.nodes.begin(), trap.nodes.end());
    }
}

std::vector<GroundState> WalkStarts::before(const Vec3& foot, const Vec3& ahead) {
    constexpr double kSameGround = 0.35;  // metres up or down
    std::vector<GroundState> starts;
    for (const double back : {1.25, 1.0, 0.75}) {
        const auto node = space_.find(space_.grid.cell_at(foot - back * ahead), foot.y(), kSameGround);
        if (node && is_good(*node)) {
            starts.push_back(space_.state_at(*node, strider_));
        }
    }
    // Rather not with a foot in the air.
    std::stable_partition(starts.begin(), starts.end(), [](const GroundState& at) {
        constexpr double kLevel = 0.01;
        return at.support_y - at.foot.y() <= kLevel;
    });
    return starts;
}

std::vector<GroundState> WalkStarts::on_path_to(const WalkNodeId& node) {
    constexpr std::size_t kMost = 6;
    std::vector<GroundState> starts;
    const auto add = [&](const WalkNodeId& id) {
        if (is_good(id)) {
            starts.push_back(space_.state_at(id, strider_));
        }
    };
    for (auto at = space_.parent(node); at && starts.size() < kMost; at = space_.parent(*at)) {
        add(*at);
    }
    add(node);
    return starts;
}

bool WalkStarts::is_good(const WalkNodeId& node) const {
    return space_.node(node).hangs == 0 && !traps_.contains(node);
}

}  // namespace campuswalk::tools::explore
