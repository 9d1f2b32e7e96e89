#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "engine/walkspace/report/walk_report.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// For each spot of an island, the storey whose plan shows it: that of the reached ground beside it, which
/// may be a little lower or higher; away from that, of what is as high as it.
std::vector<std::size_t> storeys_of_island(const engine::WalkReport& report, const engine::Island& island);

/// Where a place or a spawn is on the plans.
std::size_t storey_of(const engine::WalkReport& report, const engine::Subject& subject);

/// Where a plan has a finding's number.
struct StoreyMark {
    std::size_t storey = 0;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< x and z, metres
};

/// At most one for each storey: where the visitor stood for whom it was measured, and wherever else a good
/// part of the finding's ground is. None for what is nowhere.
std::vector<StoreyMark> marks_of(const engine::WalkReport& report, const Finding& finding);

}  // namespace campuswalk::tools::explore
