#include "tools/campuswalk/explore/one_way_walks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "engine/script/expectation.h"
#include "engine/simulation/body.h"

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::GroundState;
using engine::StrideEnd;
using engine::WalkNodeId;
using engine::WalkReport;

namespace {

/// How far beyond an edge a walk goes, metres.
constexpr double kBeyond = 1.0;
constexpr double kFarBeyond = 4.0;
/// How near a walk_to gets to its target, metres.
constexpr double kWithin = 0.05;
/// The most entrances of a trap, and edges of a hole, that walks are tried over.
constexpr std::size_t kMostEdges = 8;
constexpr double kLongestWalk = 60.0;  // seconds, with its falls

DraftStep walk_on(const Vec3& to, std::optional<double> speed) {
    return {.kind = DraftStep::Kind::walk_to, .to = to, .goes_on = true, .speed = speed};
}

/// The first of them, and some of the others.
template <typename Item>
std::vector<Item> some_of(const std::vector<Item>& all) {
    std::vector<Item> some;
    const std::size_t every = std::max<std::size_t>(1, all.size() / kMostEdges);
    for (std::size_t i = 0; i < all.size() && some.size() < kMostEdges; i += every) {
        some.push_back(all[i]);
    }
    return some;
}

/// A stride over an edge: where a walk over it may lead.
struct Crossing {
    WalkNodeId from;
    engine::Stride stride;
    std::vector<Vec3> targets;  ///< the likeliest first
};

/// Of a body that runs; a walk says how fast.
std::optional<double> speed_of(const engine::Stride& stride, const engine::AvatarProfile& avatar) {
    return stride.gait == engine::Gait::walk ? std::nullopt : std::optional(engine::running_speed(avatar));
}

class TrapWalker {
public:
    TrapWalker(const WalkReport& report, const engine::Trap& trap, const DraftPlayer& player,
               WalkStarts& starts)
        : space_(report.space),
          trap_(trap),
          inside_(trap.nodes.begin(), trap.nodes.end()),
          player_(player),
          starts_(starts) {}

    std::optional<ShownWalk> find() {
        const std::vector<Crossing> entrances = this->entrances();
        for (const Crossing& entrance : entrances) {
            const GroundState last = space_.state_at(entrance.from, starts_.strider());
            const Vec3 ahead = engine::grid_directions()[entrance.stride.direction].unit;
            if (auto shown = enter(entrance, starts_.before(last.foot, ahead))) {
                return shown;
            }
        }
        for (const Crossing& entrance : entrances) {
            if (auto shown = enter(entrance, starts_.on_path_to(entrance.from))) {
                return shown;
            }
        }
        return from_inside();
    }

private:
    std::vector<Crossing> entrances() const {
        std::vector<WalkNodeId> nodes{trap_.entrance};
        std::ranges::copy_if(trap_.nodes, std::back_inserter(nodes), [&](const WalkNodeId& node) {
            const auto from = space_.parent(node);
            return node != trap_.entrance && from && !inside_.contains(*from);
        });
        std::vector<Crossing> found;
        for (const WalkNodeId& node : some_of(nodes)) {
            const WalkNodeId from = space_.parent(node).value_or(node);
            const GroundState last = space_.state_at(from, starts_.strider());
            const engine::Stride stride = space_.node(node).stride();
            const Vec3 ahead = engine::grid_directions()[stride.direction].unit;
            found.push_back(
                {from, stride,
                 targets_inside(last.foot, space_.state_at(node, starts_.strider()).foot, ahead)});
        }
        return found;
    }

    /// A walk_to ends a little before its target.
    static std::vector<Vec3> targets_inside(const Vec3& last, const Vec3& inside, const Vec3& ahead) {
        return {inside, inside + kWithin * ahead, last + kBeyond * ahead, last + kFarBeyond * ahead};
    }

    bool is_inside(const Vec3& foot) const {
        const auto node = space_.find(space_.grid.cell_at(foot), foot.y());
        return node && inside_.contains(*node);
    }

    std::optional<ShownWalk> enter(const Crossing& entrance, const std::vector<GroundState>& from) const {
        const std::optional<double> speed = speed_of(entrance.stride, player_.avatar());
        for (const GroundState& start : from) {
            for (const Vec3& target : entrance.targets) {
                if (!speed && !leads_inside(start, target)) {
                    continue;
                }
                if (auto shown = show({start.foot, {walk_on(target, speed)}}, start.foot)) {
                    return shown;
                }
            }
        }
        return std::nullopt;
    }

    /// Whether it is worth playing a walk.
    bool leads_inside(const GroundState& start, const Vec3& target) const {
        const StrideEnd end = starts_.strider().walk_to(start, target, kWithin, kLongestWalk);
        return end.kind == StrideEnd::Kind::grounded && is_inside(end.at.foot);
    }

    /// The draft ends inside, and no way leads back from there.
    std::optional<ShownWalk> show(WalkDraft draft, const Vec3& back) const {
        const DraftEnd in = player_.play(draft);
        if (!in.failure.empty() || !in.stands_at_first || !is_inside(in.foot)) {
            return std::nullopt;
        }
        for (const auto& [kind, failure] : {std::pair(DraftStep::Kind::go_to, engine::kUnreachableCode),
                                            std::pair(DraftStep::Kind::walk_to, engine::kBlockedCode)}) {
            draft.steps.push_back({.kind = kind, .to = back});
            const DraftEnd end = player_.play(draft);
            if (end.failure == failure && is_inside(end.foot)) {
                return ShownWalk{draft, end.failure, back};
            }
            draft.steps.pop_back();
        }
        return std::nullopt;
    }

    /// Where no straight walk leads in, such as in a fall that is steered: what keeps others out doesn't mend
    /// this one.
    std::optional<ShownWalk> from_inside() const {
        std::vector<WalkNodeId> nodes{trap_.entrance};
        nodes.insert(nodes.end(), trap_.nodes.begin(), trap_.nodes.end());
        for (const WalkNodeId& node : some_of(nodes)) {
            if (auto shown = show({space_.state_at(node, starts_.strider()).foot, {}}, trap_.edge)) {
                return shown;
            }
        }
        return std::nullopt;
    }

    const engine::WalkSpace& space_;
    const engine::Trap& trap_;
    const std::set<WalkNodeId> inside_;
    const DraftPlayer& player_;
    WalkStarts& starts_;
};

/// More than a fall from there out of the world takes, also where slopes slow it down: a walk_to that its
/// target is far above ends before.
double fall_seconds(const Vec3& edge, double bottom) {
    constexpr double kSlowed = 2.0;
    constexpr double kToTheEdge = 1.0;
    const double height = edge.y() - bottom + engine::kAbyss;
    return kToTheEdge + kSlowed * std::sqrt(2.0 * height / collision::MoverSettings().gravity);
}

class HoleWalker {
public:
    HoleWalker(const engine::Hole& hole, const DraftPlayer& player, WalkStarts& starts)
        : hole_(hole), player_(player), starts_(starts) {}

    std::optional<ShownWalk> find() {
        const std::vector<engine::Hole::Edge> edges = some_of(hole_.edges);
        for (const engine::Hole::Edge& edge : edges) {
            const Vec3 ahead = engine::grid_directions()[edge.stride.direction].unit;
            if (auto shown = cross(edge, starts_.before(edge.at, ahead))) {
                return shown;
            }
        }
        for (const engine::Hole::Edge& edge : edges) {
            if (auto shown = cross(edge, starts_.on_path_to(edge.node))) {
                return shown;
            }
        }
        return std::nullopt;
    }

private:
    /// Straight on, and where a fall is steered to.
    static std::vector<Vec3> targets_beyond(const engine::Hole::Edge& edge) {
        const Vec3 ahead = engine::grid_directions()[edge.stride.direction].unit;
        std::vector<Vec3> targets{edge.at + kBeyond * ahead, edge.at + kFarBeyond * ahead};
        if (edge.stride.steering < engine::grid_directions().size()) {
            targets.push_back(edge.at + kFarBeyond * engine::grid_directions()[edge.stride.steering].unit);
        }
        return targets;
    }

    std::optional<ShownWalk> cross(const engine::Hole::Edge& edge,
                                   const std::vector<GroundState>& from) const {
        const std::optional<double> speed = speed_of(edge.stride, player_.avatar());
        for (const GroundState& start : from) {
            for (const Vec3& target : targets_beyond(edge)) {
                if (!speed && starts_.strider().walk_to(start, target, kWithin, kLongestWalk).kind ==
                                  StrideEnd::Kind::grounded) {
                    continue;
                }
                const WalkDraft draft{
                    start.foot,
                    {walk_on(target, speed),
                     {.kind = DraftStep::Kind::wait,
                      .seconds = fall_seconds(edge.at, player_.campus().world.bounds().min.y())}}};
                const DraftEnd end = player_.play(draft);
                if (end.stands_at_first && end.failure == engine::ExpectFell::kName &&
                    is_at_edge(end.stood)) {
                    return ShownWalk{draft, end.failure, start.foot};
                }
            }
        }
        return std::nullopt;
    }

    bool is_at_edge(const Vec3& foot) const {
        constexpr double kNear = 1.0;  // metres
        return std::ranges::any_of(
            hole_.edges, [&](const engine::Hole::Edge& edge) { return (edge.at - foot).norm() <= kNear; });
    }

    const engine::Hole& hole_;
    const DraftPlayer& player_;
    WalkStarts& starts_;
};

}  // namespace

std::optional<ShownWalk> walk_into_trap(const WalkReport& report, const engine::Trap& trap,
                                        const DraftPlayer& player, WalkStarts& starts) {
    return TrapWalker(report, trap, player, starts).find();
}

std::optional<ShownWalk> walk_into_hole(const engine::Hole& hole, const DraftPlayer& player,
                                        WalkStarts& starts) {
    return HoleWalker(hole, player, starts).find();
}

}  // namespace campuswalk::tools::explore
