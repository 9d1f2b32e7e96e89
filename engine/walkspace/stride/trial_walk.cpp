#include "engine/walkspace/stride/trial_walk.h"

#include <algorithm>
#include <utility>

#include "collision/world/placement.h"
#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"

namespace campuswalk::engine {

using collision::MoverState;
using collision::Vec3;

TrialWalk::TrialWalk(const collision::World& world, const StrideSettings& settings,
                     const collision::QueryFilter& filter, std::function<bool(const Vec3&)> keep_out)
    : world_(&world),
      settings_(settings),
      filter_(filter),
      keep_out_(std::move(keep_out)),
      bottom_(world.bounds().min.y()),
      mover_(world, settings.body, filter) {}

std::optional<MoverState> TrialWalk::put_down(const Vec3& foot) {
    const auto placement = collision::nearest_free_placement(*world_, filter_, foot, settings_.body.radius,
                                                             settings_.body.height, kPlacementSearch);
    if (!placement) {
        return std::nullopt;
    }
    MoverState state;
    mover_.place(state, placement->foot, 2.0 * kPlacementSearch, cache_);
    return state;
}

std::optional<TrialWalk::End> TrialWalk::walk(const MoverState& from, RoutePiece& piece, Tick most,
                                              bool may_touch) {
    begin(from);
    const Target& target = piece.target;
    const auto remaining = [&] { return flat(target.point - state_.foot).norm(); };
    TravelProgress progress;
    progress.allowed = default_timeout(remaining(), settings_.walk_speed);
    while (progress.ticks < most) {
        const Vec3 before = state_.foot;
        if (!tick(
                displacement_towards(target.point, state_.foot, settings_.walk_speed * settings_.seconds)) ||
            (keep_out_ && keep_out_(state_.foot)) || (touched_ && !may_touch)) {
            return std::nullopt;
        }
        ++progress.ticks;
        if (has_arrived(target, piece.within, state_.foot, state_.grounded)) {
            piece.ticks = progress.ticks;
            return end();
        }
        const bool at_rest = state_.grounded && state_.foot == before;
        if (at_rest ||
            progress.gives_up(remaining(), state_.grounded, settings_.walk_speed, settings_.seconds)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

std::optional<TrialWalk::End> TrialWalk::stride(const MoverState& from, RoutePiece& piece) {
    begin(from);
    const bool until_landed = piece.ticks == 0;
    while (until_landed ? !state_.grounded : static_cast<Tick>(path_.size()) < piece.ticks) {
        if (!tick(*piece.stride)) {
            return std::nullopt;
        }
    }
    piece.ticks = static_cast<Tick>(path_.size());
    return end();
}

void TrialWalk::begin(const MoverState& from) {
    state_ = from;
    stood_at_ = std::max(from.foot.y(), from.fall_from);
    path_.clear();
    falls_ = 0.0;
    touched_ = false;
    is_leaving_ = true;
}

/// False once the body has fallen below the world. On the ground at an edge it may be a little lower.
bool TrialWalk::tick(const Vec3& desired) {
    if (state_.grounded) {
        stood_at_ = edge_below(state_).y();
    }
    mover_.move(state_, desired, settings_.seconds, cache_, trace_);
    path_.push_back(state_.foot);
    if (trace_.landed) {
        falls_ += fall_to(state_.foot.y());
    }
    const bool is_touching = std::ranges::any_of(trace_.touching, [this](const collision::Touch& touch) {
        return touch.gap <= settings_.body.skin + kTouchSlack;
    });
    is_leaving_ = is_leaving_ && is_touching;
    touched_ = touched_ || (is_touching && !is_leaving_);
    return state_.grounded || state_.foot.y() >= bottom_;
}

TrialWalk::End TrialWalk::end() const {
    return {state_, falls_ + (state_.grounded ? 0.0 : fall_to(state_.foot.y())), touched_};
}

/// Steps down are no falls.
double TrialWalk::fall_to(double y) const {
    const double height = stood_at_ - y;
    return height > settings_.body.step_height ? height : 0.0;
}

}  // namespace campuswalk::engine
