#include "engine/expect/certain_timeout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <Eigen/Core>

#include "engine/script/avatar_body.h"

namespace campuswalk::engine {

namespace {

/// The least time of the steps so far, and where the avatar then is, if that is known.
class LeastTime {
public:
    LeastTime(const AvatarProfile& avatar, double fastest) : avatar_(avatar), fastest_(fastest) {}

    double seconds() const { return seconds_; }
    std::vector<CertainTimeout> take_too_short() { return std::move(too_short_); }

    void add(const SpawnStep& step) { at_ = {step.position, kPlacementSearch}; }
    void add(const TeleportStep& step) { at_ = {step.position, kPlacementSearch}; }
    void add(const WalkToStep& step) { go_to(step, step.target, step.if_blocked, "blocked"); }
    void add(const FollowStep& step) { go_to(step, step.points.back(), step.if_blocked, "blocked"); }
    void add(const GoToStep& step) { go_to(step, step.target, IfBlocked::fail, "timeout"); }
    void add(const WaitStep& step) { seconds_ += step.seconds; }
    void add(const TurnStep& step) {
        seconds_ += step.absolute ? 0.0 : std::abs(step.angle) / avatar_.turn_speed;
    }
    void add(const JumpStep&) { at_.reset(); }
    template <typename Other>
    void add(const Other&) {}

private:
    struct Position {
        Eigen::Vector3d point;
        double error = 0.0;  // metres
    };

    template <typename Step>
    void go_to(const Step& step, const Target& target, IfBlocked if_blocked, const char* code) {
        double least = 0.0;
        if (at_) {
            Eigen::Vector3d path = target.point - at_->point;
            path.y() = 0.0;
            least = std::max(0.0, path.norm() - step.within - at_->error) / fastest_;
        }
        if (if_blocked != IfBlocked::fail) {
            at_.reset();
            return;
        }
        if (step.timeout && *step.timeout < least) {
            too_short_.push_back({step.mark, code});
        }
        seconds_ += least;
        at_ = {target.point, step.within};
    }

    const AvatarProfile& avatar_;
    double fastest_;
    double seconds_ = 0.0;
    std::optional<Position> at_;
    std::vector<CertainTimeout> too_short_;
};

}  // namespace

std::vector<CertainTimeout> certain_timeouts(const Walk& walk, double fastest) {
    LeastTime time(walk.avatar, fastest);
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
