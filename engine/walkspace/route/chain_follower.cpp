#include "engine/walkspace/route/chain_follower.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"
#include "engine/walkspace/route/taut_path.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A way that is straight may slide along things that it would overlap by less, metres.
constexpr double kSlide = 0.1;
/// A straight piece may end this far above or below the node that it is headed for, metres: less than the
/// way between two floors, more than a step.
constexpr double kSameFloor = 0.35;
/// Falls that differ by less are the same, metres.
constexpr double kSameFall = 0.1;
/// Ticks more than the chain takes that a straight piece may take: one that slides along a wall is no gain.
constexpr Tick kSlack = 20;
/// The last piece may go round what stands beside the target, seconds.
constexpr double kLastPiece = 4.0;
/// Nodes this near the target are asked whether they lead there, metres.
constexpr double kNearTarget = 0.6;
/// Points that pieces go to have whole millimetres, so that they can be written down exactly.
constexpr double kPointsPerMetre = 1000.0;

Vec3 written(const Vec3& p) {
    return {std::floor(p.x() * kPointsPerMetre + 0.5) / kPointsPerMetre, 0.0,
            std::floor(p.z() * kPointsPerMetre + 0.5) / kPointsPerMetre};
}

}  // namespace

std::size_t ChainFollower::follow_guess(std::vector<ChainNode> chain, const GuessRules& rules) {
    chain_ = std::move(chain);
    std::size_t at = 0;
    const auto may_lead = [&](std::size_t node) {
        const ChainNode& goal = chain_[std::min(node, chain_.size() - 1)];
        const Vec3& foot = draft_.state().foot;
        // A line may lead away from a wall that the body stands at.
        const double room = draft_.settings().strides.body.skin + kTouchSlack;
        const double room_beside = map_.has_room_beside(foot, room) ? room : -slide_allowed();
        return straight_path(map_, foot, goal.at.foot, rules, room_beside).has_value();
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
        draft_.append(next->walked);
        at = next->node;
    }
    return at;
}

bool ChainFollower::follow_strides(std::vector<ChainNode> chain, const WalkGrid& grid, bool pieces) {
    chain_ = std::move(chain);
    std::size_t at = 0;
    bool exact = true;  // the body is in the very state of the chain's node
    while (at < chain_.size()) {
        const bool last = at + 1 == chain_.size();
        const auto next = pieces || last ? farthest(at, [](std::size_t) { return true; }) : std::nullopt;
        if (next) {
            draft_.append(next->walked);
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

Tick ChainFollower::last_ticks() const {
    return static_cast<Tick>(kLastPiece / draft_.settings().strides.seconds) + 1;
}

bool ChainFollower::is_near_goal(const Vec3& foot) const {
    const Target& target = goal_.target;
    return flat(target.point - foot).norm() <= kNearTarget &&
           (!target.has_height || std::abs(foot.y() - target.point.y()) <= kTargetLevel + kSameFloor);
}

double ChainFollower::slide_allowed() const {
    return std::min(kSlide, 0.5 * draft_.settings().strides.body.radius);
}

/// The farthest node of the chain that a straight piece leads to, found by ever larger leaps and then by
/// halving the last one; `chain_.size()` stands for the target. Pieces over several nodes are only tried
/// where they may lead.
std::optional<ChainFollower::Pull> ChainFollower::farthest(std::size_t at,
                                                           const std::function<bool(std::size_t)>& may_lead) {
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

std::optional<ChainFollower::Pull> ChainFollower::piece_to(std::size_t at, std::size_t node) {
    const bool last = node == chain_.size();
    const ChainNode& goal = chain_[last ? node - 1 : node];
    const RoutePiece piece = last ? goal_ : RoutePiece{{"", written(goal.at.foot), false}};
    const Tick most = goal.ticks - chain_[at].ticks + kSlack + (last ? last_ticks() : 0);
    const bool may_touch = node <= at + 1;
    auto walked = draft_.walk(piece, most, may_touch);
    if (!walked) {
        return std::nullopt;
    }
    const TrialWalk::End& end = walked->end;
    if ((!last && (!end.state.grounded || std::abs(end.state.foot.y() - goal.at.foot.y()) > kSameFloor)) ||
        end.falls > std::max(kHarmlessFall, falls_of_chain(at, node)) + kSameFall) {
        return std::nullopt;
    }
    const Tick inevitable = goal.tight - chain_[at].tight + (last ? tight_ticks_at_goal(walked->path) : 0);
    return walked->tight <= inevitable + kSlack ? std::optional<Pull>({node, std::move(*walked)})
                                                : std::nullopt;
}

/// The chain's own strides fall so far, roughly: a straight piece must not leap down where it takes the
/// stairs.
double ChainFollower::falls_of_chain(std::size_t from, std::size_t to) const {
    double falls = 0.0;
    for (std::size_t i = from + 1; i <= to && i < chain_.size(); ++i) {
        const double drop = edge_below(state_of(chain_[i - 1].at)).y() - chain_[i].at.foot.y();
        falls += drop > draft_.settings().strides.body.step_height ? drop : 0.0;
    }
    return falls;
}

/// The chain ends beside the target: from there on, a piece has no choice.
Tick ChainFollower::tight_ticks_at_goal(std::vector<Vec3> path) const {
    std::erase_if(path, [&](const Vec3& foot) { return !is_near_goal(foot); });
    return draft_.tight_ticks(path);
}

void ChainFollower::take_stride(const Stride& stride, const WalkGrid& grid) {
    const RouteSettings& settings = draft_.settings();
    const collision::MoverState& state = draft_.state();
    const StrideEnd end = draft_.strider().take({state.foot, state.support_y}, stride, grid);
    const double length = settings.strides.walk_speed * settings.strides.seconds;
    const Vec3 ahead = length * grid_directions()[stride.direction].unit;
    draft_.append_stride({goal_.target, goal_.within, ahead, end.ticks_ahead});
    if (end.ticks > end.ticks_ahead) {
        const Vec3 steered = stride.steering == Stride::kStraightOn ? ahead
                             : stride.steering == Stride::kLetGo
                                 ? Vec3(Vec3::Zero())
                                 : Vec3(length * grid_directions()[stride.steering].unit);
        draft_.append_stride({goal_.target, goal_.within, steered, end.ticks - end.ticks_ahead});
    }
}

}  // namespace campuswalk::engine
