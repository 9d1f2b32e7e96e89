#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/base/query_counters.h"
#include "collision/mover/mover.h"
#include "engine/events/popups.h"
#include "engine/expect/expectation_set.h"
#include "engine/record/tick_record.h"
#include "engine/script/avatar_body.h"
#include "engine/script/player.h"
#include "engine/script/walk.h"
#include "engine/simulation/contact_detector.h"
#include "engine/simulation/state_hash.h"
#include "engine/simulation/stuck_watch.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// The step that ended a walk early.
struct Stop {
    SourceMark mark;
    std::string code;  ///< "blocked", "enclosed", "fell" or "timeout", or that of what was expected there
    std::string message;
    std::optional<FailureScene> scene = {};  ///< none: where the walk ended
};

/// The frame loop: script, mover, senses, events, pop-ups, one after the other, a tick at a time. It knows no
/// observer and keeps no clock but the tick count. `campus` and `walk` must outlive it.
class Simulation {
public:
    Simulation(const scene::Campus& campus, const Walk& walk);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    bool finished() const { return finished_; }

    /// Plays one tick; the record is valid until the next call. Tick 0 is the spawn.
    const TickRecord& step();

    /// The exits of everything that is still met, at the last tick. Call once, when finished.
    const TickRecord& leave_everything();

    const std::optional<Stop>& stop() const { return stop_; }
    double distance() const { return distance_; }
    std::uint64_t hash() const { return hash_.value(); }
    const collision::QueryCounters& counters() const { return counters_; }

private:
    void move(const Intent& intent);
    void leave_place(const char* cause);
    void set_down(const Eigen::Vector3d& foot, const std::string& label);
    void stay_where_it_is();
    void report_placement(const Intent& intent);
    void report_transitions(const char* cause);
    void report_transition(const DetectedTransition& detected, const char* cause);
    void report_fall();
    void report_stuck(const Intent& intent);
    void report_step_end();
    void report_timeout();
    std::string obstacle() const;

    // Information windows (simulation_popups.cpp): of what is met and left, and what has lasted long enough.
    void meet_popup(const DetectedTransition& detected);
    void leave_popup(const DetectedTransition& detected);
    void report_dwelling();
    void open_popup(std::size_t index, double at);

    // What steps do that take no time (simulation_effects.cpp).
    void apply(const Step& step);
    void carry_out(const SnapshotStep& step);
    void carry_out(const CrouchStep& step);
    void carry_out(const EnableStep& step);
    void carry_out(const ExpectStep& step);
    template <typename Other>
    void carry_out(const Other&) {}
    bool switch_objects(const EnableStep& step);
    void make_room(const EnableStep& step);
    void drop_without_ground();
    void report_push();

    void fill_record();
    const TickRecord& finish_record();

    Eigen::Vector3d position_at(double fraction) const;
    Event& add(EventKind kind, std::string object, double at = 1.0);
    void end_walk(const SourceMark& mark, std::string code, std::string message);

    const scene::Campus& campus_;
    const Walk& walk_;
    double dt_;
    std::vector<bool> disabled_;  ///< by object
    collision::QueryFilter solids_;
    collision::CapsuleMover mover_;
    ScriptPlayer script_;
    ContactDetector contact_detector_;
    Popups popups_;
    std::vector<OpenPopup> windows_;  ///< those that are open, oldest first
    StepExpectations step_expectations_;

    Tick tick_ = -1;
    AvatarState avatar_;
    collision::MoverState body_;
    collision::MoveTrace trace_;
    std::vector<DetectedTransition> transitions_;
    std::vector<Event> events_;
    std::vector<const Step*> effects_;
    std::vector<const SnapshotStep*> snapshots_;
    const char* placed_ = nullptr;  ///< why the avatar was put somewhere this tick
    bool jumped_ = false;           ///< in the air by a jump
    StuckWatch stuck_;
    /// Out of what the avatar was pushed where it was put down.
    struct Push {
        std::string label;
        Eigen::Vector3d from = Eigen::Vector3d::Zero();
        double distance = 0.0;  ///< metres
        collision::ObjectId out_of{};
    };
    std::optional<Push> push_;
    TickRecord record_;

    bool finished_ = false;
    std::optional<Stop> stop_;
    double distance_ = 0.0;
    StateHash hash_;
    collision::QueryCounters counters_;
};

/// How far above a written-down place the avatar looks for a free one, metres (see standing_place). Ground is
/// looked for twice as far below what it found, so at least as far below what was written.
constexpr double kPlacementSearch = 0.5;

}  // namespace campuswalk::engine
