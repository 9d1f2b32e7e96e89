#include "engine/walkspace/route/route.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"
#include "engine/walkspace/route/chain_follower.h"
#include "engine/walkspace/route/route_draft.h"
#include "engine/walkspace/route/taut_path.h"
#include "engine/walkspace/stride/standing_room.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A way that is straight but for this share isn't worth a search, and neither are these ticks.
constexpr double kNearlyStraight = 1.02;
constexpr Tick kFewTicks = 5;
/// A visitor walks round what stands in the way rather than into it, seconds.
constexpr double kSecondsRoundATouch = 1.0;
/// Nodes are at least this far from what is avoided, metres.
constexpr double kRoomBesideAvoided = 0.1;
/// So many guesses are walked before the way is looked for by walking everywhere.
constexpr int kMostGuesses = 12;
/// After so many searches a leg is walked as the last chain goes, stride by stride.
constexpr int kMostSearches = 12;

/// Plans one leg of a route: from where the draft ends to a target.
class LegPlanner {
public:
    LegPlanner(RouteDraft& draft, GroundMap& map, const Target& target, double within)
        : draft_(draft),
          map_(map),
          settings_(draft.settings()),
          goal_{target, within},
          follower_(draft, map, goal_) {}

    /// None if the target is reached.
    std::optional<NoRoute> plan() {
        if (!land()) {
            return NoRoute{goal_.target, WalkSpace(WalkGrid{})};
        }
        const RouteDraft::Mark start = draft_.mark();
        std::optional<WalkedPiece> straight;
        const auto goes_straight = [&] {
            straight = draft_.walk(goal_, std::numeric_limits<Tick>::max(), true);
            return straight && is_nearly_straight(*straight);
        };
        const bool looks_free =
            straight_path(map_, foot(), goal_.target.point, guess_rules(), -follower_.slide_allowed())
                .has_value();
        if (looks_free && goes_straight()) {
            draft_.append(*straight);
            return std::nullopt;
        }
        if (!follow_guess()) {
            if (!looks_free && goes_straight()) {  // the map is wrong
                draft_.append(*straight);
                return std::nullopt;
            }
            const collision::MoverSettings& body = settings_.strides.body;
            if (!may_stand_at(draft_.world(), settings_.solids, body, goal_.target, goal_.within)) {
                return NoRoute{goal_.target, WalkSpace(WalkGrid{}), false, true};
            }
            if (auto none = search()) {
                return none;
            }
        }
        if (straight && cost_of(*straight) <= draft_.ticks_since(start)) {
            draft_.go_back_to(start);
            draft_.append(*straight);
        }
        return std::nullopt;
    }

private:
    const Vec3& foot() const { return draft_.state().foot; }

    bool is_nearly_straight(const WalkedPiece& walked) const {
        const double distance = flat(goal_.target.point - foot()).norm();
        const double ticks = distance / (settings_.strides.walk_speed * settings_.strides.seconds);
        return walked.end.falls <= kHarmlessFall && walked.tight == 0 &&
               static_cast<double>(walked.piece.ticks) <=
                   kNearlyStraight * ticks + static_cast<double>(kFewTicks);
    }

    /// In ticks: falls and tight places count as in the exploration, and bumping into things counts as well.
    Tick cost_of(const WalkedPiece& walked) const {
        const double round = std::max(0.0, walked.end.falls - kHarmlessFall) * kSecondsRoundAFall +
                             (walked.end.touched ? kSecondsRoundATouch : 0.0);
        return walked.piece.ticks + (kTightFactor - 1) * walked.tight +
               static_cast<Tick>(round / settings_.strides.seconds);
    }

    /// Walks everywhere until the target is reached; wherever that way can't be followed, another is guessed.
    std::optional<NoRoute> search() {
        draft_.note_search();
        const WorkerWorlds worlds(draft_.world(), 1, {});
        for (int searches = 1;; ++searches) {
            WalkSpace space = explore(worlds, explore_settings(), towards_target());
            if (!space.goal) {
                const bool cut = space.is_cut_by(Bound::nodes);
                return NoRoute{goal_.target, std::move(space), cut};
            }
            if (follower_.follow_strides(chain_to(space), space.grid, searches < kMostSearches)) {
                return std::nullopt;
            }
            assert(searches < kMostSearches && "a chain can be followed stride by stride");
            if (searches >= kMostSearches) {
                return NoRoute{goal_.target, std::move(space), true};
            }
            if (!land()) {
                return NoRoute{goal_.target, WalkSpace(WalkGrid{})};
            }
            if (follow_guess()) {
                return std::nullopt;
            }
        }
    }

    GuessRules guess_rules() const {
        const collision::MoverSettings& body = settings_.strides.body;
        GuessRules rules;
        rules.is_tight = settings_.is_tight;
        rules.most_up = std::max(body.step_height, body.steepest_rise() * map_.grid().cell);
        if (settings_.keep_out) {
            rules.keep_out = [this](const Vec3& foot) { return is_close_to_what_is_avoided(foot); };
        }
        return rules;
    }

    /// By straight pieces along a way over the map; where they lead no farther, the map is wrong. Whether
    /// that leads to the target: if not, the body is where it was.
    bool follow_guess() {
        const RouteDraft::Mark start = draft_.mark();
        GuessRules rules = guess_rules();
        for (int guesses = 0; guesses < kMostGuesses; ++guesses) {
            auto guess = guess_path(map_, foot(), goal_.target, rules);
            if (!guess) {
                return false;
            }
            if (!rules.is_tight) {
                guess = pulled_taut(map_, std::move(*guess), rules);
            }
            const std::size_t end = follower_.follow_guess(chain_along(*guess), rules);
            if (end == guess->size()) {
                return true;
            }
            draft_.go_back_to(start);
            rules.blocked.push_back((*guess)[std::min(end + 1, guess->size() - 1)]);
        }
        return false;
    }

    std::vector<ChainNode> chain_along(const std::vector<GroundMap::Spot>& guess) const {
        const double length = settings_.strides.walk_speed * settings_.strides.seconds;
        std::vector<ChainNode> chain;
        double walked = 0.0;
        for (const GroundMap::Spot& spot : guess) {
            const Vec3 foot = map_.foot(spot);
            ChainNode node{{}, {foot, foot.y()}};
            if (!chain.empty()) {
                const ChainNode& before = chain.back();
                walked += flat(foot - before.at.foot).norm();
                node.ticks = static_cast<Tick>(walked / length);
                const bool tight = settings_.is_tight && settings_.is_tight(foot);
                node.tight = before.tight + (tight ? node.ticks - before.ticks : 0);
            }
            chain.push_back(node);
        }
        return chain;
    }

    /// False if the body falls out of the world.
    bool land() {
        return draft_.state().grounded ||
               draft_.append_stride({goal_.target, goal_.within, Vec3(Vec3::Zero())});
    }

    ExploreSettings explore_settings() {
        ExploreSettings settings;
        settings.strides = settings_.strides;
        settings.solids = settings_.solids;
        settings.more_starts = {{foot(), draft_.state().support_y}};
        settings.keep_rim = true;
        settings.max_nodes = settings_.max_nodes;
        if (settings_.keep_out) {
            settings.keep_out = [this](const Vec3& foot) { return is_close_to_what_is_avoided(foot); };
        }
        return settings;
    }

    TowardsPoint towards_target() {
        const auto is_goal = [this](const GroundState& at) {
            RoutePiece piece = goal_;
            if (!follower_.is_near_goal(at.foot)) {
                return false;
            }
            const auto end = draft_.trial().walk(state_of(at), piece, follower_.last_ticks(), true);
            return end && end->falls <= kHarmlessFall;
        };
        return {goal_.target.point, is_goal, settings_.is_tight};
    }

    /// So that there is room for straight pieces beside it.
    bool is_close_to_what_is_avoided(const Vec3& foot) const {
        return std::ranges::any_of(grid_directions(), [&](const GridDirection& direction) {
            return settings_.keep_out(foot + kRoomBesideAvoided * direction.unit);
        });
    }

    std::vector<ChainNode> chain_to(const WalkSpace& space) {
        std::vector<ChainNode> chain;
        std::vector<WalkNodeId> ids{*space.goal};
        while (const auto parent = space.parent(ids.back())) {
            ids.push_back(*parent);
        }
        std::ranges::reverse(ids);
        chain.push_back({{}, {foot(), draft_.state().support_y}, 0});
        for (std::size_t i = 1; i < ids.size(); ++i) {
            const Stride stride = space.node(ids[i]).stride();
            const StrideEnd end = draft_.strider().take(chain.back().at, stride, space.grid);
            const bool tight = settings_.is_tight && settings_.is_tight(end.at.foot);
            chain.push_back({stride, end.at, chain.back().ticks + end.ticks,
                             chain.back().tight + (tight ? end.ticks : 0)});
        }
        return chain;
    }

    RouteDraft& draft_;
    GroundMap& map_;
    const RouteSettings& settings_;
    const RoutePiece goal_;  ///< the piece that ends at the target
    ChainFollower follower_;
};

}  // namespace

std::variant<Route, NoRoute> plan_route(const collision::World& world, const RouteSettings& settings,
                                        const RouteRequest& request) {
    GroundMaps own_maps;
    GroundMap& map = (settings.ground != nullptr ? *settings.ground : own_maps)
                         .of(world, settings.strides.body, settings.solids);
    RouteDraft draft(world, settings, request.from);
    for (const Target& target : request.to) {
        const double within = &target == &request.to.back() ? request.within : RoutePiece().within;
        if (auto none = LegPlanner(draft, map, target, within).plan()) {
            return std::move(*none);
        }
    }
    return draft.route();
}

}  // namespace campuswalk::engine
