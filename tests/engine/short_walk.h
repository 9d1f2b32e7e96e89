#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/record/observer.h"
#include "engine/script/walk.h"
#include "engine/simulation/run_walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

// Steps as a loader would make them.

SpawnStep spawn_at(const Eigen::Vector3d& foot, double yaw = 0.0, const std::string& label = "start");
/// A target without a height, as `[x, z]`.
WalkToStep walk_to(double x, double z, const std::string& label = "goal");
/// Goes on with the next step when something is in the way.
WalkToStep walk_to_or_proceed(double x, double z, std::optional<double> speed = std::nullopt);
WaitStep wait_for(double seconds);
TurnStep turn_by(double degrees);
TurnStep turn_to(double degrees);
LookAtStep look_at(const Target& target);
TeleportStep teleport_to(const Eigen::Vector3d& foot, std::optional<double> yaw = std::nullopt,
                         const std::string& label = "elsewhere");
SnapshotStep snapshot(const std::string& name);
/// Through points without heights; the last is labelled "goal".
FollowStep follow(const std::vector<Eigen::Vector3d>& points);
JumpStep jump_up(double speed, double forward = 0.0);
/// "KIND OBJECT" as for `pattern`.
WaitUntilStep wait_until(const std::string& words, double timeout = 30.0);
CrouchStep set_height(double height);
SpeedStep set_speed(double speed);
EnableStep enable(const std::string& glob);
EnableStep disable(const std::string& glob);

/// A walk called "stroll" with everything else at its default.
Walk walk_of(std::vector<Step> steps);

/// "KIND OBJECT", or "KIND" for any object.
EventPattern pattern(const std::string& words);

// Expectations, each marked with a line of "a.walk.yaml", column 5.

ExpectNever expect_never(const std::string& words, int line = 0);
/// The items are marked with the lines after that of the whole.
ExpectSequence expect_sequence(const std::vector<std::string>& words, int line = 0);
ExpectCount expect_count(const std::string& words, std::optional<int> equals,
                         std::optional<int> at_least = {}, std::optional<int> at_most = {}, int line = 0);
ExpectReaches expect_reaches(const Target& target, double within, int line = 0);

/// "KIND OBJECT" of an event.
std::string event_line(const Event& event);

/// The value of a field, which must be there and of that type.
template <typename Value>
const Value& field(const Event& event, std::string_view name) {
    for (const Field& f : event.fields) {
        if (f.name == name) {
            return std::get<Value>(f.value);
        }
    }
    throw std::runtime_error(event_line(event) + " has no " + std::string(name));
}
bool has_field(const Event& event, std::string_view name);

/// Records everything that observers see of a walk.
class Recorder final : public Observer {
public:
    struct TickState {
        Tick tick = 0;
        double time = 0.0;
        AvatarState avatar;
        std::vector<std::size_t> open_popups;
        std::vector<std::string> snapshots;
    };

    void begin(const Walk& walk) override;
    void on_tick(const TickRecord& record) override;
    void end() override;

    /// "begin", "tick" and "end" in the order of the calls.
    const std::vector<std::string>& calls() const { return calls_; }
    const std::vector<TickState>& states() const { return states_; }
    const std::vector<Event>& events() const { return events_; }

    /// The events that match "KIND OBJECT", or "KIND" for any object.
    std::vector<Event> events(const std::string& words) const;
    /// event_line() of every event except walk.start and walk.end.
    std::vector<std::string> event_lines() const;
    /// The avatar at the end of a tick.
    const AvatarState& at(Tick tick) const;

private:
    std::vector<std::string> calls_;
    std::vector<TickState> states_;
    std::vector<Event> events_;
};

/// The summary of a walk, and what observers saw of it.
struct RecordedRun {
    WalkSummary summary;
    Recorder recorder;
};
RecordedRun run(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
