#include "tools/campuswalk/explore/barrier_walks.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/script/failure_codes.h"
#include "engine/script/travel.h"
#include "engine/walkspace/route/campus_route.h"
#include "scene/base/glob.h"

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::ReasonKind;

namespace {

/// A visitor, and what isn't in the way.
struct Mended {
    engine::AvatarProfile avatar;
    std::vector<std::string> disabled;
};

/// Changes it so that the barrier is none. False if no single change does that.
bool mend(const scene::Campus& campus, const engine::Barrier& barrier, Mended& mended) {
    constexpr double kSlack = 0.02;       // metres
    constexpr double kSlopeSlack = 0.01;  // radians
    engine::AvatarProfile& avatar = mended.avatar;
    switch (barrier.kind) {
        case ReasonKind::riser:
            avatar.step_height = std::max(avatar.step_height, barrier.measured + kSlack);
            return true;
        case ReasonKind::slope:
            avatar.max_slope = std::max(avatar.max_slope, barrier.measured + kSlopeSlack);
            return true;
        case ReasonKind::opening:
            avatar.radius = std::min(avatar.radius, 0.5 * (barrier.measured - kSlack));
            return true;
        case ReasonKind::headroom:
            avatar.height = std::min(avatar.height, barrier.measured - kSlack);
            return true;
        case ReasonKind::object:
            if (!barrier.object || barrier.is_node) {
                return false;
            }
            mended.disabled.push_back(scene::glob_for(campus.objects[index_of(*barrier.object)].id));
            return true;
        case ReasonKind::sequence:
            return std::ranges::all_of(
                barrier.parts, [&](const engine::Barrier& part) { return mend(campus, part, mended); });
        default:
            return false;
    }
}

/// The visitor for whom the barrier is none, or who goes where it isn't: as on the campus once it is mended.
std::optional<DraftPlayer> unhindered(const DraftPlayer& player, const engine::Barrier& barrier) {
    Mended mended{player.avatar(), player.disabled()};
    if (!mend(player.campus(), barrier, mended)) {
        return std::nullopt;
    }
    return DraftPlayer(player.campus(), std::move(mended.avatar), std::move(mended.disabled));
}

/// No way that is longer mends anything.
constexpr std::size_t kMostNodes = 20'000;

class BarrierWalker {
public:
    BarrierWalker(const engine::Barrier& barrier, const Vec3& goal, const DraftPlayer& player,
                  WalkStarts& starts)
        : barrier_(barrier), goal_(goal), player_(player), mended_(unhindered(player, barrier)) {
        for (const auto& start :
             starts.before(barrier.from, engine::flat(goal - barrier.from).normalized())) {
            from_.push_back(start.foot);
        }
        from_.push_back(barrier.from);
    }

    /// Straight on, if that gets there once the barrier is away; else by whatever way then leads there.
    std::optional<ShownWalk> straight_or_round() const {
        std::optional<ShownWalk> straight;
        for (const Vec3& start : from_) {
            if (auto shown = straight_from(start)) {
                straight = shown;
                if (passes_mended(shown->draft)) {
                    return straight;
                }
            }
        }
        const auto round = by_route();
        return round ? round : straight;
    }

    /// By a go_to: no way leads there, as the report has found.
    std::optional<ShownWalk> by_route() const {
        for (const Vec3& start : from_) {
            if (!player_.play({start, {}}).stands_at_first) {
                continue;
            }
            const ShownWalk walk{{start, {{.kind = DraftStep::Kind::go_to, .to = goal_}}},
                                 std::string(engine::kUnreachableCode),
                                 goal_};
            return !mended_ || has_route(*mended_, start) ? std::optional(walk) : std::nullopt;
        }
        return std::nullopt;
    }

private:
    std::optional<ShownWalk> straight_from(const Vec3& start) const {
        constexpr double kAtBarrier = 1.0;  // metres
        const ShownWalk walk{{start, {{.to = goal_}}}, std::string(engine::kBlockedCode), goal_};
        const DraftEnd end = player_.play(as_tried(walk.draft));
        return end.stands_at_first && end.is_blocked && end.failure.empty() &&
                       (end.foot - barrier_.from).norm() <= kAtBarrier
                   ? std::optional(walk)
                   : std::nullopt;
    }

    bool has_route(const DraftPlayer& player, const Vec3& start) const {
        const std::vector<bool> disabled = player.disabled_objects();
        engine::RouteSettings settings = engine::route_settings(player.campus(), player.avatar(), &disabled);
        settings.max_nodes = kMostNodes;
        const auto body = engine::body_at(start, player.campus(), settings);
        return body && std::holds_alternative<engine::Route>(engine::plan_route(
                           player.campus().world, settings, {*body, {{list_of(goal_), goal_, true}}}));
    }

    /// Without a failure's search for a way round.
    static WalkDraft as_tried(WalkDraft draft) {
        draft.steps.front().goes_on = true;
        return draft;
    }

    /// As far as that is known.
    bool passes_mended(const WalkDraft& draft) const {
        if (!mended_) {
            return true;
        }
        const DraftEnd end = mended_->play(as_tried(draft));
        return end.failure.empty() && !end.is_blocked;
    }

    const engine::Barrier& barrier_;
    const Vec3 goal_;
    const DraftPlayer& player_;
    const std::optional<DraftPlayer> mended_;
    std::vector<Vec3> from_;
};

}  // namespace

std::optional<ShownWalk> walk_at_barrier(const engine::Barrier& barrier, const Vec3& goal,
                                         const DraftPlayer& player, WalkStarts& starts) {
    return BarrierWalker(barrier, goal, player, starts).straight_or_round();
}

std::optional<ShownWalk> walk_to_goal(const engine::Barrier& barrier, const Vec3& goal,
                                      const DraftPlayer& player, WalkStarts& starts) {
    const BarrierWalker walker(barrier, goal, player, starts);
    const auto walk = walker.by_route();
    return walk ? walk : walker.straight_or_round();
}

}  // namespace campuswalk::tools::explore
