#include "engine/walkspace/stride/stride.h"

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
/// A body in the air that moves less in a second hangs somewhere, metres.
constexpr double kCaught = 0.005;
/// Seconds; see Stride::steers_after.
constexpr double kFifth = 0.2;
/// In a fall, after so many ticks, half as many more and so on, it is asked whether it goes on for ever.
constexpr std::size_t kFirstLook = 8;
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

double jump_height(const StrideSettings& settings) {
    return 0.5 * settings.jump_speed * settings.jump_speed / settings.body.gravity;
}

double jump_length(const StrideSettings& settings) {
    const double seconds = 2.0 * settings.jump_speed / settings.body.gravity;
    return seconds * settings.run_speed + settings.body.radius;
}

StrideEnd Strider::take(const GroundState& from, const Stride& stride, const WalkGrid& grid) {
    return take(from, stride, grid, [](const GroundState&, double) { return true; });
}

StrideEnd Strider::take(const GroundState& from, const Stride& stride, const WalkGrid& grid,
                        const IsWorthIt& is_worth_it) {
    const GridDirection& direction = grid_directions()[stride.direction];
    const GridCell cell = grid.cell_at(from.foot);
    const Vec3 goal = grid.center({cell.x + direction.x, cell.z + direction.z});
    const double length = speed_of(stride.gait) * settings_.seconds;
    const double ahead = (goal - from.foot).dot(direction.unit);
    const int count = std::max(1, static_cast<int>(std::floor(ahead / length + 0.5)));
    const Vec3 desired = length * direction.unit;

    StrideEnd end;
    if (shares_fall(from, stride, grid)) {
        // What the last stride did after that is no part of this one's path.
        shared_.forks.resize(std::min<std::size_t>(stride.steers_after + 1U, shared_.forks.size()));
        const SharedFall::Fork& fork = shared_.forks.back();
        state_ = fork.state;
        path_.resize(fork.ticks);
        obstructed_ticks_ = fork.obstructed_ticks;
        end = shared_.end;
    } else {
        start(from);
        if (stride.gait == Gait::jump) {
            mover_.jump(state_, settings_.jump_speed);
            end.left_ground = true;
            end.edge = from.foot;
        }
        walk_ahead(desired, count, steepest_rise_ * length + kStepRise, is_worth_it, end);
        if (!state_.grounded) {
            shared_ = {from, stride.direction, stride.gait, grid.cell, end, {}};
            note_fork();
        }
    }
    std::size_t ahead_until = path_.size();
    if (!state_.grounded) {
        end.clean = false;
        const bool straight_on = stride.steering == Stride::kStraightOn;
        const bool let_go = stride.steering == Stride::kLetGo;
        ahead_until = shared_.forks.front().ticks + ticks_in(stride.steers_after);
        fall_ahead(desired, stride.steers_after);
        fall(straight_on ? desired
             : let_go    ? Vec3(Vec3::Zero())
                         : Vec3(length * grid_directions()[stride.steering].unit),
             path_.size() - shared_.forks.front().ticks);
    }
    end.ticks_ahead = static_cast<int>(std::min(ahead_until, path_.size()));
    finish(end);
    return end;
}

/// From where a body stands.
void Strider::start(const GroundState& from) {
    state_ = state_of(from);
    path_.clear();
    obstructed_ticks_ = 0;
    shared_.forks.clear();
}

/// Until it leaves the ground, nothing moves any more, or something is in the way and it isn't worth it.
void Strider::walk_ahead(const Vec3& desired, int most, double level_rise, const IsWorthIt& is_worth_it,
                         StrideEnd& end) {
    while (state_.grounded && static_cast<int>(path_.size()) < most) {
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
        } else if (const int left = most - static_cast<int>(path_.size());
                   obstructed_ && left > 0 &&
                   !is_worth_it({state_.foot, state_.support_y}, left * desired.norm())) {
            end.given_up = true;
            break;
        }
    }
}

StrideEnd Strider::walk_to(const GroundState& from, const Vec3& point, double within, double seconds) {
    StrideEnd end;
    end.clean = false;
    start(from);
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
        if (state_.grounded ? still : state_.foot.y() < bottom_) {
            break;
        }
    }
    finish(end);
    return end;
}

StrideEnd Strider::put_down(const Vec3& foot) {
    StrideEnd end;
    end.clean = false;
    start({});
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
        fall(Vec3::Zero(), 0);
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

void Strider::forget_dense_surroundings() {
    constexpr std::size_t kDense = 128;  // triangles
    if (cache_.contacts.capacity() > kDense) {
        cache_ = {};
    }
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

/// Whether the last stride began as this one does.
bool Strider::shares_fall(const GroundState& from, const Stride& stride, const WalkGrid& grid) const {
    return !shared_.forks.empty() && shared_.from == from && shared_.direction == stride.direction &&
           shared_.gait == stride.gait && shared_.cell == grid.cell;
}

void Strider::note_fork() {
    shared_.forks.push_back({path_.size(), state_, obstructed_ticks_});
}

std::size_t Strider::ticks_in(std::size_t fifths) const {
    return static_cast<std::size_t>(
        std::floor(kFifth * static_cast<double>(fifths) / settings_.seconds + 0.5));
}

/// Until so many fifths of a second after it left the ground.
void Strider::fall_ahead(const Vec3& ahead, std::size_t fifths) {
    const std::size_t edge = shared_.forks.front().ticks;
    while (shared_.forks.size() <= fifths && is_falling()) {
        const std::size_t until = edge + ticks_in(shared_.forks.size());
        while (path_.size() < until && is_falling()) {
            fall_for_a_tick(ahead);
        }
        if (is_falling()) {
            note_fork();
        }
    }
}

/// Until it lands. It has been in the air for some ticks.
void Strider::fall(const Vec3& desired, std::size_t ticks) {
    const auto most = static_cast<std::size_t>(kMaxFall / settings_.seconds);
    std::size_t next_look = ticks + kFirstLook;
    for (std::size_t i = ticks; i < most && is_falling() && !is_caught(i); ++i) {
        if (i == next_look) {
            next_look += next_look / 2;
            if (falls_out_of_the_world(desired)) {
                state_.foot.y() = bottom_ - 1.0;
                break;
            }
        }
        fall_for_a_tick(desired);
    }
}

/// Whether it hangs in a wedge of faces too steep to stand on, after so many ticks in the air: it has moved
/// next to nothing for a second.
bool Strider::is_caught(std::size_t ticks) const {
    const std::size_t second = std::max<std::size_t>(2, ticks_in(5));
    if (ticks < second || path_.size() <= second) {
        return false;
    }
    const auto is_here = [&](std::size_t ticks_ago) {
        return (path_[path_.size() - 1 - ticks_ago] - state_.foot).cwiseAbs().maxCoeff() <= kCaught;
    };
    return is_here(second) && is_here(second / 2);
}

void Strider::fall_for_a_tick(const Vec3& desired) {
    tick(desired);
    if (fall_limits_ && !state_.grounded && !fall_limits_->overlaps({state_.foot, state_.foot})) {
        state_.foot.y() = bottom_ - 1.0;
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
        return !collision::any_in_box(**mesh, shape, X_mesh_box);
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
