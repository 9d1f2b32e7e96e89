#include "engine/walkspace/route/route.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"
#include "engine/walkspace/route/taut_path.h"
#include "engine/walkspace/stride/standing_room.h"
#include "engine/walkspace/stride/trial_walk.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

using collision::MoverState;
using collision::Vec3;

namespace {

/// A way that is straight but for this share isn't worth a search, and neither are these ticks.
constexpr double kNearlyStraight = 1.02;
constexpr Tick kFewTicks = 5;
/// A way that is straight may slide along things that it would overlap by less, metres.
constexpr double kSlide = 0.1;
/// A straight piece may end this far above or below the node that it is headed for, metres: less than the
/// way between two floors, more than a step.
constexpr double kSameFloor = 0.35;
/// Falls that differ by less are the same, metres.
constexpr double kSameFall = 0.1;
/// Ticks more than the chain takes that a straight piece may take: one that slides along a wall is no gain.
constexpr Tick kSlack = 20;
/// A visitor walks round what stands in the way rather than into it, seconds.
constexpr double kSecondsRoundATouch = 1.0;
/// The last piece may go round what stands beside the target, seconds.
constexpr double kLastPiece = 4.0;
/// Nodes this near the target are asked whether they lead there, metres.
constexpr double kNearTarget = 0.6;
/// Nodes are at least this far from what is avoided, metres.
constexpr double kRoomBesideAvoided = 0.1;
/// So many guesses are walked before the way is looked for by walking everywhere.
constexpr int kMostGuesses = 12;
/// After so many searches a leg is walked as the last chain goes, stride by stride.
constexpr int kMostSearches = 12;
/// Points that pieces go to have whole millimetres, so that they can be written down exactly.
constexpr double kPointsPerMetre = 1000.0;

Vec3 written(const Vec3& p) {
    return {std::floor(p.x() * kPointsPerMetre + 0.5) / kPointsPerMetre, 0.0,
            std::floor(p.z() * kPointsPerMetre + 0.5) / kPointsPerMetre};
}

/// A node of the chain that the route follows.
struct ChainNode {
    Stride stride;  ///< to it
    GroundState at;
    Tick ticks = 0;  ///< from the chain's start
    Tick tight = 0;  ///< of them, of strides that end in tight places
};

/// A walked piece and where on the chain it leads.
struct Pull {
    std::size_t node = 0;
    RoutePiece piece;
    TrialWalk::End end;
    std::vector<Vec3> path;
    Tick tight = 0;  ///< ticks in tight places
};

class Planner {
public:
    Planner(const collision::World& world, const RouteSettings& settings, const RouteRequest& request)
        : worlds_(world, 1, {}),
          settings_(settings),
          strider_(world, settings.strides, settings.solids),
          trial_(world, settings.strides, settings.solids, settings.keep_out),
          map_((settings.ground != nullptr ? *settings.ground : own_maps_)
                   .of(world, settings.strides.body, settings.solids)),
          state_(request.from) {
        route_.path.push_back(state_.foot);
    }

    /// None if the target is reached.
    std::optional<NoRoute> go_to(const Target& target, double within) {
        target_ = target;
        within_ = within;
        if (!land()) {
            return NoRoute{target_, WalkSpace(WalkGrid{})};
        }
        const Mark start = mark();
        std::optional<Pull> straight;
        const auto goes_straight = [&] {
            straight = walk_straight();
            return straight && is_nearly_straight(*straight);
        };
        const bool looks_free =
            straight_path(map_, state_.foot, target_.point, guess_rules(), -slide_allowed()).has_value();
        if (looks_free && goes_straight()) {
            append(*straight);
            return std::nullopt;
        }
        if (!follow_guess()) {
            if (!looks_free && goes_straight()) {  // the map is wrong
                append(*straight);
                return std::nullopt;
            }
            if (!may_stand_at(worlds_[0], settings_.solids, settings_.strides.body, target_, within_)) {
                return NoRoute{target_, WalkSpace(WalkGrid{}), false, true};
            }
            if (auto none = search()) {
                return none;
            }
        }
        if (straight && cost_of(*straight) <= ticks_since(start.points)) {
            go_back_to(start);
            append(*straight);
        }
        return std::nullopt;
    }

    Route finished() { return std::move(route_); }

private:
    /// Of the route's path from this point on; tight places count as in the exploration.
    Tick ticks_since(std::size_t point) const {
        const std::vector<Vec3> path(route_.path.begin() + static_cast<std::ptrdiff_t>(point),
                                     route_.path.end());
        return static_cast<Tick>(path.size()) + (kTightFactor - 1) * tight_ticks(path);
    }

    RoutePiece last_piece() const { return {target_, within_}; }

    std::optional<Pull> walk_straight() {
        Pull pull{0, last_piece(), {}, {}};
        const auto end = trial_.walk(state_, pull.piece, std::numeric_limits<Tick>::max(), true);
        if (!end) {
            return std::nullopt;
        }
        pull.end = *end;
        pull.path = trial_.path();
        pull.tight = tight_ticks(pull.path);
        return pull;
    }

    Tick tight_ticks(const std::vector<Vec3>& path) const {
        return settings_.is_tight ? static_cast<Tick>(std::ranges::count_if(path, settings_.is_tight)) : 0;
    }

    /// The chain ends beside the target: from there on, a piece has no choice.
    Tick tight_ticks_at_target(std::vector<Vec3> path) const {
        std::erase_if(path, [&](const Vec3& foot) { return !is_near_target(foot); });
        return tight_ticks(path);
    }

    bool is_nearly_straight(const Pull& pull) const {
        const double distance = flat(target_.point - state_.foot).norm();
        const double ticks = distance / (settings_.strides.walk_speed * settings_.strides.seconds);
        return pull.end.falls <= kHarmlessFall && pull.tight == 0 &&
               static_cast<double>(pull.piece.ticks) <=
                   kNearlyStraight * ticks + static_cast<double>(kFewTicks);
    }

    /// In ticks: falls and tight places count as in the exploration, and bumping into things counts as well.
    Tick cost_of(const Pull& pull) const {
        const double round = std::max(0.0, pull.end.falls - kHarmlessFall) * kSecondsRoundAFall +
                             (pull.end.touched ? kSecondsRoundATouch : 0.0);
        return pull.piece.ticks + (kTightFactor - 1) * pull.tight +
               static_cast<Tick>(round / settings_.strides.seconds);
    }

    /// Walks everywhere until the target is reached; wherever that way can't be followed, another is guessed.
    std::optional<NoRoute> search() {
        route_.searched = true;
        for (int searches = 1;; ++searches) {
            WalkSpace space = explore(worlds_, explore_settings(), goal());
            if (!space.goal) {
                const bool cut = space.is_cut_by(Bound::nodes);
                return NoRoute{target_, std::move(space), cut};
            }
            chain_ = chain_to(space);
            if (follow_chain(space.grid, searches < kMostSearches)) {
                return std::nullopt;
            }
            assert(searches < kMostSearches && "a chain can be followed stride by stride");
            if (searches >= kMostSearches) {
                return NoRoute{target_, std::move(space), true};
            }
            if (!land()) {
                return NoRoute{target_, WalkSpace(WalkGrid{})};
            }
            if (follow_guess()) {
                return std::nullopt;
            }
        }
    }

    /// Where one has come to.
    struct Mark {
        MoverState state;
        std::size_t pieces = 0;
        std::size_t points = 0;
    };

    Mark mark() const { return {state_, route_.pieces.size(), route_.path.size()}; }

    void go_back_to(const Mark& mark) {
        state_ = mark.state;
        route_.pieces.resize(mark.pieces);
        route_.path.resize(mark.points);
    }

    double slide_allowed() const { return std::min(kSlide, 0.5 * settings_.strides.body.radius); }

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
        const Mark start = mark();
        GuessRules rules = guess_rules();
        for (int guesses = 0; guesses < kMostGuesses; ++guesses) {
            auto guess = guess_path(map_, state_.foot, target_, rules);
            if (!guess) {
                return false;
            }
            if (!rules.is_tight) {
                guess = pulled_taut(map_, std::move(*guess), rules);
            }
            chain_ = chain_along(*guess);
            const std::size_t end = follow_pieces(rules);
            if (end == chain_.size()) {
                return true;
            }
            go_back_to(start);
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

    /// The node of the chain from which none leads on; its size at the target.
    std::size_t follow_pieces(const GuessRules& rules) {
        std::size_t at = 0;
        const auto may_lead = [&](std::size_t node) {
            const ChainNode& goal = chain_[std::min(node, chain_.size() - 1)];
            // A line may lead away from a wall that the body stands at.
            const double room = settings_.strides.body.skin + kTouchSlack;
            const double room_beside = map_.has_room_beside(state_.foot, room) ? room : -slide_allowed();
            return straight_path(map_, state_.foot, goal.at.foot, rules, room_beside).has_value();
        };
        while (at < chain_.size()) {
            const std::size_t most = chain_.size() - at;
            const auto leads = [&](std::size_t length) { return may_lead(at + length); };
            auto next = piece_to(at, at + farthest_by_leaps(most, leads));
            if (!next) {
                next = farthest(at, may_lead);
            }
            if (!next) {
                break;
            }
            append(*next);
            at = next->node;
        }
        return at;
    }

    /// False if the body falls out of the world.
    bool land() { return state_.grounded || append_stride({target_, within_, Vec3(Vec3::Zero())}); }

    ExploreSettings explore_settings() {
        ExploreSettings settings;
        settings.strides = settings_.strides;
        settings.solids = settings_.solids;
        settings.more_starts = {{state_.foot, state_.support_y}};
        settings.keep_rim = true;
        settings.max_nodes = settings_.max_nodes;
        if (settings_.keep_out) {
            settings.keep_out = [this](const Vec3& foot) { return is_close_to_what_is_avoided(foot); };
        }
        return settings;
    }

    TowardsPoint goal() {
        const auto is_goal = [this](const GroundState& at) {
            RoutePiece piece = last_piece();
            if (!is_near_target(at.foot)) {
                return false;
            }
            const auto end = trial_.walk(state_of(at), piece, last_ticks(), true);
            return end && end->falls <= kHarmlessFall;
        };
        return {target_.point, is_goal, settings_.is_tight};
    }

    /// So that there is room for straight pieces beside it.
    bool is_close_to_what_is_avoided(const Vec3& foot) const {
        return std::ranges::any_of(grid_directions(), [&](const GridDirection& direction) {
            return settings_.keep_out(foot + kRoomBesideAvoided * direction.unit);
        });
    }

    Tick last_ticks() const { return static_cast<Tick>(kLastPiece / settings_.strides.seconds) + 1; }

    bool is_near_target(const Vec3& foot) const {
        return flat(target_.point - foot).norm() <= kNearTarget &&
               (!target_.has_height || std::abs(foot.y() - target_.point.y()) <= kTargetLevel + kSameFloor);
    }

    std::vector<ChainNode> chain_to(const WalkSpace& space) {
        std::vector<ChainNode> chain;
        std::vector<WalkNodeId> ids{*space.goal};
        while (const auto parent = space.parent(ids.back())) {
            ids.push_back(*parent);
        }
        std::ranges::reverse(ids);
        chain.push_back({{}, {state_.foot, state_.support_y}, 0});
        for (std::size_t i = 1; i < ids.size(); ++i) {
            const Stride stride = space.node(ids[i]).stride();
            const StrideEnd end = strider_.take(chain.back().at, stride, space.grid);
            const bool tight = settings_.is_tight && settings_.is_tight(end.at.foot);
            chain.push_back({stride, end.at, chain.back().ticks + end.ticks,
                             chain.back().tight + (tight ? end.ticks : 0)});
        }
        return chain;
    }

    /// Whether the target is reached. If not, the body stands where no node of the chain can be walked to
    /// from, and has come nearer.
    bool follow_chain(const WalkGrid& grid, bool pull) {
        std::size_t at = 0;
        bool exact = true;  // the body is in the very state of the chain's node
        while (at < chain_.size()) {
            const bool last = at + 1 == chain_.size();
            auto next = pull || last ? farthest(at, [](std::size_t) { return true; }) : std::nullopt;
            if (next) {
                append(*next);
                at = next->node;
                exact = false;
            } else if (exact && !last) {
                take_stride(chain_[++at].stride, grid);
            } else {
                return false;
            }
        }
        return true;
    }

    /// The farthest node of the chain that a straight piece leads to, found by ever larger leaps and then by
    /// halving the last one; `chain_.size()` stands for the target. Pieces over several nodes are only tried
    /// where they may lead.
    template <typename MayLead>
    std::optional<Pull> farthest(std::size_t at, const MayLead& may_lead) {
        const auto try_piece = [&](std::size_t node) {
            return node <= at + 1 || may_lead(node) ? piece_to(at, node) : std::nullopt;
        };
        std::optional<Pull> best;
        const std::size_t end = chain_.size();
        std::size_t fails = end + 1;
        for (std::size_t leap = 1; best ? best->node < end : leap <= 4; leap *= 2) {
            const std::size_t node = std::min(at + leap, end);
            if (auto pull = try_piece(node)) {
                best = std::move(pull);
            } else if (best || node == end) {
                fails = node;
                break;
            }
        }
        while (best && best->node + 1 < fails) {
            const std::size_t middle = best->node + (fails - best->node) / 2;
            if (auto pull = try_piece(middle)) {
                best = std::move(pull);
            } else {
                fails = middle;
            }
        }
        return best;
    }

    std::optional<Pull> piece_to(std::size_t at, std::size_t node) {
        const bool last = node == chain_.size();
        const ChainNode& goal = chain_[last ? node - 1 : node];
        Pull pull{node, last_piece(), {}, {}};
        if (!last) {
            pull.piece = {{"", written(goal.at.foot), false}};
        }
        const Tick most = goal.ticks - chain_[at].ticks + kSlack + (last ? last_ticks() : 0);
        const bool may_touch = node <= at + 1;
        const auto end = trial_.walk(state_, pull.piece, most, may_touch);
        if (!end ||
            (!last &&
             (!end->state.grounded || std::abs(end->state.foot.y() - goal.at.foot.y()) > kSameFloor)) ||
            end->falls > std::max(kHarmlessFall, falls_of_chain(at, node)) + kSameFall) {
            return std::nullopt;
        }
        pull.end = *end;
        pull.path = trial_.path();
        pull.tight = tight_ticks(pull.path);
        const Tick inevitable = goal.tight - chain_[at].tight + (last ? tight_ticks_at_target(pull.path) : 0);
        return pull.tight <= inevitable + kSlack ? std::optional(pull) : std::nullopt;
    }

    /// Of the chain's own strides, roughly: a straight piece must not leap down where the chain takes the
    /// stairs.
    double falls_of_chain(std::size_t from, std::size_t to) const {
        double falls = 0.0;
        for (std::size_t i = from + 1; i <= to && i < chain_.size(); ++i) {
            const double drop = edge_below(state_of(chain_[i - 1].at)).y() - chain_[i].at.foot.y();
            falls += drop > settings_.strides.body.step_height ? drop : 0.0;
        }
        return falls;
    }

    void take_stride(const Stride& stride, const WalkGrid& grid) {
        const StrideEnd end = strider_.take({state_.foot, state_.support_y}, stride, grid);
        const double length = settings_.strides.walk_speed * settings_.strides.seconds;
        const Vec3 ahead = length * grid_directions()[stride.direction].unit;
        append_stride({target_, within_, ahead, end.ticks_ahead});
        if (end.ticks > end.ticks_ahead) {
            const Vec3 steered = stride.steering == Stride::kStraightOn ? ahead
                                 : stride.steering == Stride::kLetGo
                                     ? Vec3(Vec3::Zero())
                                     : Vec3(length * grid_directions()[stride.steering].unit);
            append_stride({target_, within_, steered, end.ticks - end.ticks_ahead});
        }
    }

    bool append_stride(const RoutePiece& piece) {
        Pull pull{0, piece, {}, {}};
        const auto end = trial_.stride(state_, pull.piece);
        if (end) {
            pull.end = *end;
            pull.path = trial_.path();
            append(pull);
        }
        return end.has_value();
    }

    void append(const Pull& pull) {
        route_.pieces.push_back(pull.piece);
        route_.path.insert(route_.path.end(), pull.path.begin(), pull.path.end());
        state_ = pull.end.state;
    }

    const WorkerWorlds worlds_;
    const RouteSettings& settings_;
    Strider strider_;
    TrialWalk trial_;
    GroundMaps own_maps_;
    GroundMap& map_;
    MoverState state_;  ///< at the end of the route so far
    Route route_;
    Target target_;
    double within_ = 0.0;
    std::vector<ChainNode> chain_;
};

}  // namespace

std::variant<Route, NoRoute> plan_route(const collision::World& world, const RouteSettings& settings,
                                        const RouteRequest& request) {
    Planner planner(world, settings, request);
    for (std::size_t i = 0; i < request.to.size(); ++i) {
        const bool last = i + 1 == request.to.size();
        if (auto none = planner.go_to(request.to[i], last ? request.within : RoutePiece().within)) {
            return std::move(*none);
        }
    }
    return planner.finished();
}

}  // namespace campuswalk::engine
