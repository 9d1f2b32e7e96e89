#include "engine/expect/certain_timeout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <Eigen/Core>

#include "collision/geometry/trigonometry.h"
#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"

namespace campuswalk::engine {

namespace {

/// The least time of the steps so far, and where the avatar then is, if that is known.
class LeastTime {
public:
    explicit LeastTime(const AvatarProfile& avatar) : avatar_(avatar), speed_(avatar.speed) {}

    double seconds() const { return seconds_; }
    std::vector<CertainTimeout> take_too_short() { return std::move(too_short_); }

    void add(const SpawnStep& step) {
        at_ = {step.position, kPlacementSearch};
        yaw_ = step.yaw;
    }
    void add(const TeleportStep& step) {
        at_ = {step.position, kPlacementSearch};
        yaw_ = step.yaw ? step.yaw : yaw_;
    }
    void add(const WalkToStep& step) { go_to(step, {step.target}, step.if_blocked, "blocked"); }
    void add(const FollowStep& step) { go_to(step, step.points, step.if_blocked, "blocked"); }
    void add(const GoToStep& step) {
        std::vector<Target> points = step.through;
        points.push_back(step.target);
        go_to(step, points, IfBlocked::fail, "timeout");
    }
    void add(const WaitStep& step) { seconds_ += step.seconds; }
    void add(const TurnStep& step) {
        const double known = yaw_ ? collision::wrapped_angle(step.angle - *yaw_) : 0.0;
        seconds_ += std::abs(step.absolute ? known : step.angle) / avatar_.turn_speed;
        if (step.absolute) {
            yaw_ = step.angle;
        } else if (yaw_) {
            *yaw_ += step.angle;
        }
    }
    void add(const LookAtStep&) { yaw_.reset(); }
    void add(const SpeedStep& step) { speed_ = step.speed; }
    void add(const JumpStep& step) {
        if (step.forward > 0.0) {
            at_.reset();
        }
    }
    template <typename Other>
    void add(const Other&) {}

private:
    struct Position {
        Eigen::Vector3d point;
        double error = 0.0;  // metres
    };

    /// Straight from point to point, each of which counts as passed within as much as the last.
    template <typename Step>
    void go_to(const Step& step, const std::vector<Target>& points, IfBlocked if_blocked, const char* code) {
        double length = -step.within;
        for (std::size_t i = at_ ? 0 : 1; i < points.size(); ++i) {
            const Position from = i > 0 ? Position{points[i - 1].point, 2.0 * step.within} : *at_;
            length += std::max(0.0, flat(points[i].point - from.point).norm() - from.error);
        }
        const double least = std::max(0.0, length) / step.speed.value_or(speed_);
        yaw_.reset();
        if (if_blocked != IfBlocked::fail) {
            at_.reset();
            return;
        }
        if (step.timeout && *step.timeout < least) {
            too_short_.push_back({step.mark, code});
        }
        seconds_ += least;
        at_ = {points.back().point, step.within};
    }

    const AvatarProfile& avatar_;
    double speed_;  // of steps that set none, metres per second
    double seconds_ = 0.0;
    std::optional<Position> at_;
    std::optional<double> yaw_;  // radians
    std::vector<CertainTimeout> too_short_;
};

}  // namespace

std::vector<CertainTimeout> certain_timeouts(const Walk& walk) {
    LeastTime time(walk.avatar);
    for (const Step& step : walk.steps) {
        std::visit([&time](const auto& any) { time.add(any); }, step);
    }
    std::vector<CertainTimeout> certain = time.take_too_short();
    if (walk.timeout && *walk.timeout < time.seconds()) {
        certain.push_back({walk.status.mark, "timeout"});
    }
    return certain;
}

}  // namespace campuswalk::engine
