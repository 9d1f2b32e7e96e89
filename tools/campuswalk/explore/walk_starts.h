#pragma once

#include <set>
#include <vector>

#include "engine/walkspace/report/walk_report.h"

namespace campuswalk::tools::explore {

/// Finds where minimal walks begin: on ground that a visitor gets to, is no trap, and doesn't end under the
/// feet, so that what mends the campus finds nobody in its place.
class WalkStarts {
public:
    /// All must outlive it.
    WalkStarts(const engine::WalkReport& report, engine::Strider& strider);

    /// Some strides before a place at which a visitor stands who goes `ahead` (of length one) from there: a
    /// metre straight back if possible.
    std::vector<engine::GroundState> before(const collision::Vec3& foot, const collision::Vec3& ahead);
    /// Along the way by which the node was reached, and the node itself last.
    std::vector<engine::GroundState> on_path_to(const engine::WalkNodeId& node);

    engine::Strider& strider() { return strider_; }

private:
    bool is_good(const engine::WalkNodeId& node) const;

    const engine::WalkSpace& space_;
    engine::Strider& strider_;
    std::set<engine::WalkNodeId> traps_;
};

}  // namespace campuswalk::tools::explore
