#include "engine/walkspace/stride.h"

#include <algorithm>
#include <cmath>

#include "collision/mesh/mesh_query.h"
#include "collision/world/placement.h"
#include "engine/script/avatar_body.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// A body that moves less in a tick than this stands still, metres.
constexpr double kStill = 1e-9;
/// Seconds; see Stride::steers_after.
constexpr double kFifth = 0.2;
/// In a fall, after so many ticks, half as many more and so on, it is asked whether it goes on for ever.
constexpr std::size_t kFirstLook = 16;
/// What is nearer than this to a fall may be touched, metres.
constexpr double kFreeMargin = 0.05;
/// One of so many obstructed ticks of a stride tells what is touched: along a wall, all would tell the same.
constexpr int kTicksBetweenTouches = 8;
/// Beyond the slope's own rise in a tick, the body climbed or descended a step, metres.
constexpr double kStepRise = 0.01;

}  // namespace

collision::MoverState state_of(const GroundState& at) {
    collision::MoverState state;
    state.foot = at.foot;
    state.support_y = at.support_y;
    state.grounded = true;
    return state;
}

Vec3 edge_below(const collision::MoverState& state) {
    return {state.foot.x(), std::max(state.foot.y(), state.support_y), state.foot.z()};
}

collision::MoverSettings StrideSettings::upright_body() const {
    collision::MoverSettings upright = body;
    upright.height = full_height.value_or(body.height);
    return upright;
}

Strider::Strider(const collision::World& world, const StrideSettings& settings,
                 const collision::QueryFilter& filter)
    : world_(&world),
      settings_(settings),
      filter_(filter),
      bottom_(world.bounds().min.y()),
      steepest_rise_(settings.body.steepest_rise()),
      mover_(world, settings.body, filter),
      touched_(world.size(), false) {}

StrideEnd Strider::take(const GroundState& from, const Stride& stride, const WalkGrid& grid) {
    const GridDirection& direction = grid_directions()[stride.direction];
    const GridCell cell = grid.cell_at(from.foot);
    const Vec3 goal = grid.center({cell.x + direction.x, cell.z + direction.z});
    const double length = speed_of(stride.gait) * settings_.seconds;
    const double ahead = (goal - from.foot).dot(direction.unit);
    const int count = std::max(1, static_cast<int>(std::floor(ahead / length + 0.5)));
    const Vec3 desired = length * direction.unit;

    StrideEnd end;
    state_ = state_of(from);
    path_.clear();
    obstructed_ticks_ = 0;
    if (stride.gait == Gait::jump) {
        mover_.jump(state_, settings_.jump_speed);
        end.left_ground = true;
        end.edge = from.foot;
    }
    const double level_rise = steepest_rise_ * length + kStepRise;
    while (state_.grounded && static_cast<int>(path_.size()) < count) {
        const Vec3 before = state_.foot;
        const Vec3 edge = edge_below(state_);
        tick(desired);
        const Vec3 moved = state_.foot - before;
        if (state_.grounded && moved.cwiseAbs().maxCoeff() <= kStill) {
            end.clean = false;
            break;  // every further tick would do the same
        }
        end.clean = end.clean && !obstructed_ && std::abs(moved.y()) <= level_rise;
        if (!state_.grounded) {
            end.left_ground = true;
            end.edge = edge;
        }
    }
    std::size_t ahead_until = path_.size();
    if (!state_.grounded) {
        const bool straight_on = stride.steering == Stride::kStraightOn;
        const bool let_go = stride.steering == Stride::kLetGo;
        const auto steers_after =
            static_cast<std::size_t>(std::floor(kFifth * stride.steers_after / settings_.seconds + 0.5));
        ahead_until += steers_after;
        fall(desired,
             straight_on ? desired
             : let_go    ? Vec3(Vec3::Zero())
                         : Vec3(length * grid_directions()[stride.steering].unit),
             steers_after, end);
    }
    end.ticks_ahead = static_cast<int>(std::min(ahead_until, path_.size()));
    finish(end);
    return end;
}

StrideEnd Strider::walk_to(const GroundState& from, const Vec3& point, double within, double seconds) {
    StrideEnd end;
    end.clean = false;
    state_ = state_of(from);
    path_.clear();
    obstructed_ticks_ = 0;
    const double length = settings_.walk_speed * settings_.seconds;
    const int most = static_cast<int>(std::ceil(seconds / settings_.seconds));
    while (static_cast<int>(path_.size()) < most) {
        const Vec3 direction(point.x() - state_.foot.x(), 0.0, point.z() - state_.foot.z());
        const double distance = direction.norm();
        if (distance <= within && state_.grounded) {
            break;
        }
        const Vec3 before = state_.foot;
        const Vec3 edge = edge_below(state_);
        const bool grounded = state_.grounded;
        tick(distance > 0.0 ? Vec3(direction * (std::min(distance, length) / distance)) : Vec3::Zero());
        if (grounded && !state_.grounded) {
            end.left_ground = true;
            end.edge = edge;
        }
        const bool still = (state_.foot - before).cwiseAbs().maxCoeff() <= kStill;
        if ((state_.grounded && still) || state_.foot.y() < bottom_) {
            break;
        }
    }
    finish(end);
    return end;
}

StrideEnd Strider::put_down(const Vec3& foot) {
    StrideEnd end;
    end.clean = false;
    path_.clear();
    obstructed_ticks_ = 0;
    const auto placement = collision::nearest_free_placement(
        *world_, filter_, foot, settings_.body.radius, settings_.upright_body().height, kPlacementSearch);
    if (!placement) {
        end.kind = StrideEnd::Kind::gone;
        return end;
    }
    mover_.place(state_, placement->foot, 2.0 * kPlacementSearch, cache_);
    if (!state_.grounded) {
        end.left_ground = true;
        end.edge = state_.foot;
        fall(Vec3::Zero(), Vec3::Zero(), 0, end);
    }
    finish(end);
    return end;
}

bool Strider::hangs(const GroundState& at) const {
    const double rise = settings_.body.radius * (1.0 - settings_.body.min_up);
    return at.support_y - at.foot.y() > rise + kStepRise;
}

bool Strider::has_headroom(const GroundState& at) {
    return !settings_.full_height ||
           mover_.resized(state_of(at), *settings_.full_height, upright_cache_).has_value();
}

void Strider::tick(const Vec3& desired) {
    const Vec3 before = state_.foot;
    mover_.advance(state_, desired, settings_.seconds, cache_, trace_);
    path_.push_back(state_.foot);
    ++ticks_;
    obstructed_ = collision::horizontal_norm(state_.foot - before - desired) > kStill;
    if (obstructed_ && obstructed_ticks_++ % kTicksBetweenTouches == 0) {
        mover_.touch(state_, cache_, trace_);
        for (const collision::Touch& touch : trace_.touching) {
            if (touch.gap <= settings_.body.skin + kTouchSlack) {
                touched_[index_of(touch.object)] = true;
            }
        }
    }
}

/// Ahead for so many ticks, then steered.
void Strider::fall(const Vec3& ahead, const Vec3& steered, std::size_t steers_after, StrideEnd& end) {
    end.clean = false;
    const auto most = static_cast<std::size_t>(kMaxFall / settings_.seconds);
    std::size_t next_look = steers_after + kFirstLook;
    for (std::size_t i = 0; i < most && !state_.grounded && state_.foot.y() >= bottom_; ++i) {
        if (i == next_look) {
            next_look += next_look / 2;
            if (falls_out_of_the_world(steered)) {
                state_.foot.y() = bottom_ - 1.0;
                break;
            }
        }
        tick(i < steers_after ? ahead : steered);
        if (fall_limits_ && !state_.grounded && !fall_limits_->overlaps({state_.foot, state_.foot})) {
            state_.foot.y() = bottom_ - 1.0;
        }
    }
}

/// Whether a body that moves on as `desired` will touch nothing any more: there is no solid in a box around
/// the rest of its fall. That is sooner known than played.
bool Strider::falls_out_of_the_world(const Vec3& desired) {
    if (state_.vertical_speed > 0.0) {
        return false;
    }
    const double seconds = seconds_to_bottom(state_.foot, -state_.vertical_speed);
    const Vec3 drift =
        (seconds / settings_.seconds + 1.0) * desired + (seconds + settings_.seconds) * state_.slide_velocity;
    collision::Aabb fall;
    fall.extend(state_.foot);
    fall.extend(state_.foot + drift);
    fall = fall.grown(settings_.body.radius + settings_.body.skin + kFreeMargin);
    fall.max.y() = state_.foot.y() + settings_.body.height + kFreeMargin;
    fall.min.y() = bottom_ - kFreeMargin;
    return is_free(fall);
}

/// Of a fall that begins with this speed downwards.
double Strider::seconds_to_bottom(const Vec3& foot, double speed) const {
    const double gravity = settings_.body.gravity;
    const double height = std::max(0.0, foot.y() - bottom_);
    return (std::sqrt(speed * speed + 2.0 * gravity * height) - speed) / gravity;
}

/// Whether no solid has a point in the box; of those that aren't meshes, their bounds count.
bool Strider::is_free(const collision::Aabb& box) {
    world_->candidates(box, filter_, below_);
    const collision::Box shape{0.5 * (box.max - box.min)};
    return std::ranges::all_of(below_, [&](collision::ObjectId id) {
        const collision::Object& object = world_->object(id);
        const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape);
        if (mesh == nullptr) {
            return false;
        }
        const collision::Pose& X = object.X_world_shape;
        const collision::Pose X_mesh_box{X.rotation.transpose(), X.inverse_apply(box.center())};
        collision::triangles_in_box(**mesh, shape, X_mesh_box, triangles_below_);
        return triangles_below_.empty();
    });
}

void Strider::finish(StrideEnd& end) const {
    end.ticks = static_cast<int>(path_.size());
    end.at = {state_.foot, state_.support_y};
    end.kind = state_.grounded             ? StrideEnd::Kind::grounded
               : state_.foot.y() < bottom_ ? StrideEnd::Kind::gone
                                           : StrideEnd::Kind::falling;
}

double Strider::speed_of(Gait gait) const {
    return gait == Gait::walk ? settings_.walk_speed : settings_.run_speed;
}

}  // namespace campuswalk::engine
