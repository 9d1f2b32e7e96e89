#include "engine/simulation/body.h"

#include <algorithm>

#include "collision/world/placement.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::QueryStatistics;
using Eigen::Vector3d;

namespace {

/// Falls from less than this are steps, not landings that are worth an event, metres.
constexpr double kNotableFall = 0.5;
/// Ground at most this far below the foot still supports the body, metres.
constexpr double kGroundSearch = 0.01;

}  // namespace

Body::Body(const scene::Campus& campus, const Walk& walk, const std::vector<bool>& disabled)
    : campus_(campus),
      profile_(walk.avatar),
      dt_(1.0 / walk.sim.ticks_per_second),
      solids_{collision::Detection::solid, ignored_layers(campus, walk.avatar), &disabled},
      mover_(campus.world, engine::mover_settings(walk.avatar), solids_),
      stuck_(walk.sim.ticks_per_second) {}

AvatarState Body::state() const {
    return {mover_state_.foot,
            yaw_,
            pitch_,
            mover_state_.vertical_speed,
            mover_state_.grounded,
            mover_.height() / profile_.height};
}

collision::MoverSettings Body::mover_settings() const {
    collision::MoverSettings settings = engine::mover_settings(profile_);
    settings.height = mover_.height();
    return settings;
}

std::optional<ObjectId> Body::obstacle() const {
    const auto nearest = std::ranges::min_element(trace_.touching, {}, &collision::Touch::gap);
    return nearest == trace_.touching.end() ? std::nullopt : std::optional(nearest->object);
}

bool Body::has_fallen_out_of_the_world() const {
    return foot().y() < campus_.world.bounds().min.y() - kAbyss;
}

StoppedBody Body::in_place() const {
    StoppedBody body;
    body.strides.body = mover_settings();
    body.strides.seconds = dt_;
    body.strides.walk_speed = profile_.speed;
    body.solids = solids_;
    body.at = {foot(), mover_state_.support_y};
    return body;
}

std::optional<StoppedBody> Body::stopped(const Vector3d& heading) const {
    if (!mover_state_.grounded) {
        return std::nullopt;
    }
    StoppedBody body = in_place();
    body.heading = Vector3d(heading.x(), 0.0, heading.z());
    return body;
}

std::optional<StoppedBody> Body::last_stood() const {
    if (!last_stood_) {
        return std::nullopt;
    }
    StoppedBody body = in_place();
    body.at = *last_stood_;
    return body;
}

Motion Body::follow(const Intent& intent, QueryStatistics& statistics) {
    Motion motion;
    yaw_ = intent.yaw;
    pitch_ = intent.pitch;
    if (intent.placement) {
        jumping_ = false;
        last_stood_.reset();
        motion.push = put_down(intent.placement->foot, statistics);
    } else {
        motion.jumped = intent.jump && mover_.jump(mover_state_, *intent.jump);
        jumping_ = jumping_ || motion.jumped;
        mover_.move(mover_state_, intent.move, dt_, mover_cache_, trace_, &statistics);
        for (std::size_t i = 1; i < trace_.path.size(); ++i) {
            distance_ += (trace_.path[i] - trace_.path[i - 1]).norm();
        }
        if (trace_.landed && (jumping_ || trace_.fall_height >= kNotableFall)) {
            motion.landed_from = trace_.fall_height;
        }
        jumping_ = jumping_ && !mover_state_.grounded;
    }
    if (mover_state_.grounded) {
        last_stood_ = GroundState{foot(), mover_state_.support_y};
    }
    motion.stuck = stuck_.update(foot(), intent.move.norm());
    return motion;
}

bool Body::resize(double height, QueryStatistics& statistics) {
    const auto resized = mover_.resized(mover_state_, height, mover_cache_, &statistics);
    if (resized) {
        mover_ = *resized;
    }
    return resized.has_value();
}

std::optional<ObjectId> Body::obstruction(double height, QueryStatistics& statistics) const {
    return collision::obstruction(campus_.world, solids_, foot(), profile_.radius, height, &statistics);
}

/// A solid that is enabled where the body is pushes it aside.
Body::Adjustment Body::adjust_to_enabled(QueryStatistics& statistics) {
    Adjustment adjustment;
    mover_cache_.clear();
    if (const auto solid = obstruction(height(), statistics)) {
        if (collision::nearest_free_placement(campus_.world, solids_, foot(), profile_.radius, height(),
                                              kPlacementSearch, &statistics)) {
            adjustment.push = put_down(foot(), statistics);
        } else {
            adjustment.enclosed_by = solid;
        }
    }
    trace_in_place(statistics);
    return adjustment;
}

/// A body at rest doesn't query its ground again by itself.
void Body::adjust_to_disabled(QueryStatistics& statistics) {
    mover_cache_.clear();
    collision::MoverState probe;
    mover_.place(probe, foot(), kGroundSearch, mover_cache_, &statistics);
    if (mover_state_.grounded && !probe.grounded) {
        mover_state_.leave_ground(0.0, foot().y());
    }
    trace_in_place(statistics);
}

/// At the given position or, if that isn't free, beside the obstacle.
std::optional<Push> Body::put_down(const Vector3d& foot, QueryStatistics& statistics) {
    // check_walk has refused positions without a free placement nearby.
    const collision::FreePlacement placement =
        collision::nearest_free_placement(campus_.world, solids_, foot, profile_.radius, height(),
                                          kPlacementSearch, &statistics)
            .value_or(collision::FreePlacement{foot, std::nullopt});
    std::optional<Push> push;
    if (placement.pushed_out_of) {
        push = Push{foot, (placement.foot - foot).norm(), *placement.pushed_out_of};
    }
    mover_.place(mover_state_, placement.foot, 2.0 * kPlacementSearch, mover_cache_, &statistics);
    trace_in_place(statistics);
    return push;
}

/// Sets the trace of a body that doesn't move.
void Body::trace_in_place(QueryStatistics& statistics) {
    trace_.path.assign(1, foot());
    trace_.landed = false;
    mover_.touch(mover_state_, mover_cache_, trace_, &statistics);
}

}  // namespace campuswalk::engine
