#include "tools/campuswalk/explore/storey_marks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::WalkReport;

namespace {

/// A finding's ground that is smaller, and a smaller share of it, needs no number of its own: m².
constexpr double kGoodPart = 5.0;
constexpr double kGoodShare = 0.1;

Eigen::Vector2d on_plan(const Vec3& at) {
    return {at.x(), at.z()};
}

/// A finding's ground, by storey.
class GroundByStorey {
public:
    void add(std::size_t storey, const Vec3& foot) { feet_[storey].push_back(foot); }

    /// On each storey with a good part of it, where it is nearest to the middle of that.
    std::vector<StoreyMark> marks(double cell_area) const {
        std::size_t all = 0;
        for (const auto& [storey, feet] : feet_) {
            all += feet.size();
        }
        std::vector<StoreyMark> marks;
        for (const auto& [storey, feet] : feet_) {
            const auto count = static_cast<double>(feet.size());
            if (count * cell_area >= kGoodPart || count >= kGoodShare * static_cast<double>(all)) {
                marks.push_back({storey, on_plan(nearest_to_middle(feet))});
            }
        }
        return marks;
    }

private:
    static Vec3 nearest_to_middle(const std::vector<Vec3>& feet) {
        Vec3 middle = Vec3::Zero();
        for (const Vec3& foot : feet) {
            middle += foot / static_cast<double>(feet.size());
        }
        return *std::ranges::min_element(feet, {},
                                         [&](const Vec3& foot) { return (foot - middle).squaredNorm(); });
    }

    std::map<std::size_t, std::vector<Vec3>> feet_;
};

std::vector<StoreyMark> ground_marks(const WalkReport& report, const Finding& finding) {
    GroundByStorey ground;
    for (const std::size_t island : finding.islands) {
        const std::vector<engine::UnreachedSpot>& spots = report.islands[island].island.spots;
        const std::vector<std::size_t> storeys = storeys_of_island(report, report.islands[island].island);
        for (std::size_t i = 0; i < spots.size(); ++i) {
            ground.add(storeys[i], spots[i].at.foot);
        }
    }
    if (finding.kind == FindingKind::trap || finding.kind == FindingKind::stuck) {
        for (const engine::WalkNodeId& node : report.traps[*finding.index].nodes) {
            ground.add(report.storeys.of(node), report.space.position(node));
        }
    }
    return ground.marks(report.space.grid.cell * report.space.grid.cell);
}

/// Where the visitor stood for whom it was measured.
std::size_t storey_before(const WalkReport& report, const Finding& finding) {
    switch (finding.kind) {
        case FindingKind::hole:
            return report.storeys.of(report.holes[*finding.index].edges.front().node);
        case FindingKind::island:  // its place is the first spot
            return storeys_of_island(report, report.islands[finding.islands.front()].island).front();
        default:
            return engine::storey_near(report.space, report.storeys,
                                       finding.barrier ? finding.barrier->from : *finding.at);
    }
}

}  // namespace

std::vector<std::size_t> storeys_of_island(const WalkReport& report, const engine::Island& island) {
    constexpr double kBeside = 2.0;  // metres
    std::vector<std::optional<std::size_t>> beside;
    std::map<double, std::size_t> by_height;
    for (const engine::UnreachedSpot& spot : island.spots) {
        auto node = engine::node_near(report.space, spot.at.foot, kBeside);
        if (node &&
            std::abs(report.space.position(*node).y() - spot.at.foot.y()) >= engine::kLeastStoreyHeight) {
            node.reset();
        }
        beside.push_back(node ? std::optional(report.storeys.of(*node)) : std::nullopt);
        if (node) {
            by_height.emplace(spot.at.foot.y(), *beside.back());
        }
    }
    const auto as_high = [&](double y) {
        const auto above = by_height.lower_bound(y);
        auto nearest = above;
        if (above == by_height.end() ||
            (above != by_height.begin() && y - std::prev(above)->first < above->first - y)) {
            nearest = above == by_height.begin() ? above : std::prev(above);
        }
        return nearest != by_height.end() && std::abs(nearest->first - y) < engine::kLeastStoreyHeight
                   ? nearest->second
                   : engine::storey_at_height(report.storeys, y);
    };
    std::vector<std::size_t> storeys;
    for (std::size_t i = 0; i < beside.size(); ++i) {
        storeys.push_back(beside[i] ? *beside[i] : as_high(island.spots[i].at.foot.y()));
    }
    return storeys;
}

std::size_t storey_of(const WalkReport& report, const engine::Subject& subject) {
    if (subject.node) {
        return report.storeys.of(*subject.node);
    }
    if (subject.island) {
        const engine::Island& island = report.islands[*subject.island].island;
        const auto nearest = std::ranges::min_element(
            island.spots, {},
            [&](const engine::UnreachedSpot& spot) { return (spot.at.foot - subject.at).squaredNorm(); });
        return storeys_of_island(report, island)[static_cast<std::size_t>(nearest - island.spots.begin())];
    }
    return engine::storey_near(report.space, report.storeys, subject.at);
}

std::vector<StoreyMark> marks_of(const WalkReport& report, const Finding& finding) {
    if (!finding.at) {
        return {};
    }
    std::vector<StoreyMark> marks{{storey_before(report, finding), on_plan(*finding.at)}};
    for (const StoreyMark& mark : ground_marks(report, finding)) {
        if (mark.storey != marks.front().storey) {
            marks.push_back(mark);
        }
    }
    return marks;
}

}  // namespace campuswalk::tools::explore
