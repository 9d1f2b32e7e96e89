#include "engine/script/planned_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/geometry/trigonometry.h"
#include "collision/mover/mover_settings.h"
#include "engine/script/curve_walk.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

/// Where the avatar would be after the steps so far, and when.
class Plan {
public:
    explicit Plan(const AvatarProfile& avatar) : avatar_(avatar), pace_(avatar.speed) {}

    double seconds() const { return seconds_; }

    void add(const SpawnStep& step) { put(step.position, step.yaw); }
    void add(const TeleportStep& step) { put(step.position, step.yaw.value_or(yaw_)); }
    void add(const WalkToStep& step) {
        const double distance = distance_to(step.target.point);
        seconds_ += std::max(0.0, distance - step.within) / step.speed.value_or(pace_);
        go_to(position_, step.target.point);
    }
    void add(const FollowStep& step) {
        CurveWalk curve;
        curve.start(position_, step.points);
        seconds_ += std::max(0.0, curve.length() - step.within) / step.speed.value_or(pace_);
        go_to(step.points.size() > 1 ? step.points[step.points.size() - 2].point : position_,
              step.points.back().point);
    }
    void add(const WaitStep& step) { seconds_ += step.seconds; }
    void add(const TurnStep& step) {
        const double angle = step.absolute ? collision::wrapped_angle(step.angle - yaw_) : step.angle;
        turn(angle);
    }
    void add(const LookAtStep& step) {
        turn(collision::wrapped_angle(yaw_towards(position_, step.target.point) - yaw_));
    }
    void add(const JumpStep& step) { seconds_ += 2.0 * step.speed / collision::MoverSettings().gravity; }
    void add(const WaitUntilStep&) { seconds_ = std::numeric_limits<double>::infinity(); }
    void add(const SpeedStep& step) { pace_ = step.speed; }
    template <InstantStep Instant>
    void add(const Instant&) {}

private:
    void put(const Vector3d& position, double yaw) {
        position_ = position;
        yaw_ = yaw;
    }
    double distance_to(const Vector3d& point) const {
        return Vector3d(point.x() - position_.x(), 0.0, point.z() - position_.z()).norm();
    }
    double yaw_towards(const Vector3d& from, const Vector3d& to) const {
        const Vector3d way = to - from;
        return way.x() == 0.0 && way.z() == 0.0 ? yaw_ : collision::angle_of(-way.x(), -way.z());
    }
    void go_to(const Vector3d& from, const Vector3d& to) { put(to, yaw_towards(from, to)); }
    void turn(double angle) {
        seconds_ += std::abs(angle) / avatar_.turn_speed;
        yaw_ += angle;
    }

    const AvatarProfile& avatar_;
    double pace_;
    Vector3d position_ = Vector3d::Zero();
    double yaw_ = 0.0;
    double seconds_ = 0.0;
};

}  // namespace

std::optional<double> planned_seconds(const Walk& walk) {
    Plan plan(walk.avatar);
    for (const Step& step : walk.steps) {
        std::visit([&plan](const auto& each) { plan.add(each); }, step);
    }
    return std::isfinite(plan.seconds()) ? std::optional(plan.seconds()) : std::nullopt;
}

}  // namespace campuswalk::engine
