#include "tests/engine/short_walk.h"

#include <array>
#include <stdexcept>
#include <utility>

#include "engine/script/event_pattern.h"
#include "tests/support/angles.h"

namespace campuswalk::engine {

SpawnStep spawn_at(const Eigen::Vector3d& foot, double yaw, const std::string& label) {
    return {{}, label, foot, yaw};
}

WalkToStep walk_to(double x, double z, const std::string& label) {
    WalkToStep step;
    step.target = {label, {x, 0.0, z}, false};
    return step;
}

WalkToStep walk_to_or_proceed(double x, double z, std::optional<double> speed) {
    WalkToStep step = walk_to(x, z);
    step.if_blocked = IfBlocked::proceed;
    step.speed = speed;
    return step;
}

WaitStep wait_for(double seconds) {
    WaitStep step;
    step.seconds = seconds;
    return step;
}

TurnStep turn_by(double degrees) {
    TurnStep step;
    step.angle = support::radians(degrees);
    return step;
}

TurnStep turn_to(double degrees) {
    TurnStep step = turn_by(degrees);
    step.absolute = true;
    return step;
}

LookAtStep look_at(const Target& target) {
    LookAtStep step;
    step.target = target;
    return step;
}

TeleportStep teleport_to(const Eigen::Vector3d& foot, std::optional<double> yaw, const std::string& label) {
    return {{}, label, foot, yaw};
}

SnapshotStep snapshot(const std::string& name) {
    SnapshotStep step;
    step.name = name;
    return step;
}

FollowStep follow(const std::vector<Eigen::Vector3d>& points) {
    FollowStep step;
    for (const Eigen::Vector3d& point : points) {
        step.points.push_back({"via", point, false});
    }
    step.points.back().label = "goal";
    return step;
}

JumpStep jump_up(double speed, double forward) {
    return {{}, speed, forward};
}

WaitUntilStep wait_until(const std::string& words, double timeout) {
    return {{}, pattern(words), timeout};
}

CrouchStep set_height(double height) {
    return {{}, height};
}

SpeedStep set_speed(double speed) {
    return {{}, speed};
}

EnableStep enable(const std::string& glob) {
    return {{}, {{{}, glob}}, true};
}

EnableStep disable(const std::string& glob) {
    return {{}, {{{}, glob}}, false};
}

Walk walk_of(std::vector<Step> steps) {
    Walk walk;
    walk.name = "stroll";
    walk.campus_name = "small";
    walk.steps = std::move(steps);
    return walk;
}

EventPattern pattern(const std::string& words) {
    EventPattern made;
    const std::size_t space = words.find(' ');
    made.kind = words.substr(0, space);
    if (space != std::string::npos) {
        made.object = words.substr(space + 1);
    }
    return made;
}

namespace {

SourceMark mark_of(int line) {
    return {"a.walk.yaml", line, 5};
}

}  // namespace

ExpectNever expect_never(const std::string& words, int line) {
    ExpectNever expected;
    expected.event = pattern(words);
    expected.mark = expected.event.mark = mark_of(line);
    return expected;
}

ExpectSequence expect_sequence(const std::vector<std::string>& words, int line) {
    ExpectSequence expected;
    expected.mark = mark_of(line);
    for (const std::string& event : words) {
        expected.events.push_back(pattern(event));
        expected.events.back().mark = mark_of(++line);
    }
    return expected;
}

ExpectCount expect_count(const std::string& words, std::optional<int> equals, std::optional<int> at_least,
                         std::optional<int> at_most, int line) {
    ExpectCount expected;
    expected.event = pattern(words);
    expected.mark = expected.event.mark = mark_of(line);
    expected.times = {equals, at_least, at_most};
    return expected;
}

ExpectReaches expect_reaches(const Target& target, double within, int line) {
    ExpectReaches expected;
    expected.mark = mark_of(line);
    expected.target = target;
    expected.within = within;
    return expected;
}

std::string event_line(const Event& event) {
    return std::string(name_of(event.kind)) + " " + event.object;
}

bool has_field(const Event& event, std::string_view name) {
    for (const Field& f : event.fields) {
        if (f.name == name) {
            return true;
        }
    }
    return false;
}

void Recorder::begin(const Walk&) {
    calls_.emplace_back("begin");
}

void Recorder::on_tick(const TickRecord& record) {
    calls_.emplace_back("tick");
    TickState state{record.tick, record.time, record.avatar, {}, {}};
    for (const OpenPopup& popup : record.open_popups) {
        state.open_popups.push_back(popup.building);
    }
    for (const SnapshotStep* step : record.snapshots) {
        state.snapshots.push_back(step->name);
    }
    states_.push_back(std::move(state));
    events_.insert(events_.end(), record.events.begin(), record.events.end());
}

void Recorder::end() {
    calls_.emplace_back("end");
}

std::vector<Event> Recorder::events(const std::string& words) const {
    std::vector<Event> found;
    for (const Event& event : events_) {
        if (matches(pattern(words), event)) {
            found.push_back(event);
        }
    }
    return found;
}

std::vector<std::string> Recorder::event_lines() const {
    std::vector<std::string> lines;
    for (const Event& event : events_) {
        if (event.kind != EventKind::walk_start && event.kind != EventKind::walk_end) {
            lines.push_back(event_line(event));
        }
    }
    return lines;
}

const AvatarState& Recorder::at(Tick tick) const {
    for (const TickState& state : states_) {
        if (state.tick == tick) {
            return state.avatar;
        }
    }
    throw std::runtime_error("the walk has no tick " + std::to_string(tick));
}

RecordedRun run(const scene::Campus& campus, const Walk& walk) {
    RecordedRun result;
    const std::array<Observer*, 1> observers = {&result.recorder};
    result.summary = run_walk(campus, walk, observers);
    return result;
}

}  // namespace campuswalk::engine
