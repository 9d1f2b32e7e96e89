#include "engine/expect/can_fail.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <Eigen/Core>

#include "collision/geometry/trigonometry.h"
#include "engine/expect/evaluator.h"
#include "engine/expect/walk_bounds.h"
#include "engine/script/avatar_body.h"
#include "engine/script/failure_codes.h"
#include "engine/script/travel.h"

namespace campuswalk::engine {

namespace {

/// A time that the walk's steps exceed whatever happens. An xfail of that failure can't be wrong.
struct CertainTimeout {
    SourceMark mark;        ///< of the step, or of the walk's status
    std::string_view code;  ///< of the failure: a walk_to or follow that takes too long is `blocked`
};

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
    void add(const WalkToStep& step) { go_to(step, {step.target}, step.if_blocked, kBlockedCode); }
    void add(const FollowStep& step) { go_to(step, step.points, step.if_blocked, kBlockedCode); }
    void add(const GoToStep& step) {
        std::vector<Target> points = step.through;
        points.push_back(step.target);
        go_to(step, points, IfBlocked::fail, kTimeoutCode);
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
    void go_to(const Step& step, const std::vector<Target>& points, IfBlocked if_blocked,
               std::string_view code) {
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

/// Steps to whose target the straight line alone takes longer than they may take, and the walk, if its steps
/// wait, turn and go for longer than it may take.
std::vector<CertainTimeout> certain_timeouts(const Walk& walk) {
    LeastTime time(walk.avatar);
    for (const Step& step : walk.steps) {
        std::visit([&time](const auto& any) { time.add(any); }, step);
    }
    std::vector<CertainTimeout> certain = time.take_too_short();
    if (walk.timeout && *walk.timeout < time.seconds()) {
        certain.push_back({walk.status.mark, kTimeoutCode});
    }
    return certain;
}

PossibleVerdicts possible(const PlainExpectation& expectation, const WalkBounds& bounds) {
    return std::visit(
        [&]<typename Expected>(const Expected& expected) {
            return EvaluatorOf<Expected>::possible(expected, bounds);
        },
        expectation);
}

std::string name_of(const PlainExpectation& expectation) {
    return std::string(std::visit([](const auto& expected) { return expected.kName; }, expectation));
}

const SourceMark& mark_of(const PlainExpectation& expectation) {
    return std::visit([](const auto& expected) -> const SourceMark& { return expected.mark; }, expectation);
}

/// Adds an expectation that can't fail, or can't but fail in a walk that is expected to.
class Finder {
public:
    Finder(const Walk& walk, const WalkBounds& bounds, std::vector<VacuousExpectation>& found)
        : walk_(walk), bounds_(bounds), found_(found) {}

    void operator()(const PlainExpectation& expected) const {
        add_if_vacuous(possible(expected, bounds_), mark_of(expected), name_of(expected));
    }
    void operator()(const ExpectNot& negation) const {
        const PossibleVerdicts denied = possible(negation.what, bounds_);
        add_if_vacuous({.holds = denied.fails, .fails = denied.holds}, negation.mark,
                       "not-" + name_of(negation.what));
    }
    void operator()(const ExpectLog& log) const {
        add_if_vacuous({.holds = true, .fails = log.golden}, log.mark, std::string(ExpectLog::kName));
    }
    /// How much images may differ is decided where the run's own tolerance is known.
    void operator()(const ExpectSnapshot&) const {}
    void operator()(const ExpectVisible& expected) const {
        const bool always = expected.min_pixels <= 0 && expected.min_ratio.value_or(0.0) <= 0.0;
        const bool never = expected.min_pixels > pixels_of(expected.snapshot);
        const PossibleVerdicts seen{.holds = !never, .fails = !always};
        add_if_vacuous(expected.negated ? PossibleVerdicts{.holds = seen.fails, .fails = seen.holds} : seen,
                       expected.mark, code_of(expected));
    }

private:
    std::int64_t pixels_of(const std::string& snapshot) const {
        for (const Step& step : walk_.steps) {
            const auto* taken = std::get_if<SnapshotStep>(&step);
            if (taken != nullptr && taken->name == snapshot) {
                return static_cast<std::int64_t>(taken->camera.width) * taken->camera.height;
            }
        }
        return 0;
    }

    void add_if_vacuous(const PossibleVerdicts& verdicts, const SourceMark& mark,
                        const std::string& name) const {
        const bool must_fail = walk_.status.kind == WalkStatus::Kind::xfail;
        if (!verdicts.fails || (must_fail && !verdicts.holds)) {
            found_.push_back({mark, name, verdicts.holds});
        }
    }

    const Walk& walk_;
    const WalkBounds& bounds_;
    std::vector<VacuousExpectation>& found_;
};

}  // namespace

std::vector<VacuousExpectation> vacuous_expectations(const scene::Campus& campus, const Walk& walk) {
    std::vector<VacuousExpectation> found;
    WalkBounds at_end(campus, walk);
    at_end.come_to(walk.steps.size() + 1);
    for (const Expectation& expectation : walk.expectations) {
        std::visit(Finder(walk, at_end, found), expectation);
    }
    WalkBounds so_far(campus, walk);
    std::set<SourceMark> seen;  // the rounds of a `repeat` share them
    for (std::size_t i = 0; i < walk.steps.size(); ++i) {
        const auto* expect = std::get_if<ExpectStep>(&walk.steps[i]);
        if (expect != nullptr && seen.insert(expect->mark).second) {
            so_far.come_to(i);
            for (const Expectation& expectation : expect->expectations) {
                std::visit(Finder(walk, so_far, found), expectation);
            }
        }
    }
    for (const CertainTimeout& certain : certain_timeouts(walk)) {
        if (std::ranges::find(walk.status.codes, certain.code) != walk.status.codes.end()) {
            found.push_back({certain.mark, std::string(certain.code), false});
        }
    }
    return found;
}

}  // namespace campuswalk::engine
