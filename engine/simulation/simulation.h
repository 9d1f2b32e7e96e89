#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"
#include "engine/record/tick_record.h"
#include "engine/script/intent.h"
#include "engine/script/player.h"
#include "engine/script/walk.h"
#include "engine/simulation/body_routes.h"
#include "engine/simulation/simulation_state.h"
#include "engine/simulation/state_hash.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Simulates a walk tick by tick: intent, motion, contacts, pop-ups, steps, expectations, one after another.
/// It has no observers and no clock but the tick count. What it is constructed from must outlive it.
class Simulation {
public:
    /// The avatar does what the walk's steps say. `memory` may be null. Throws std::invalid_argument unless
    /// resolve_targets has completed the walk.
    Simulation(const scene::Campus& campus, const Walk& walk, RouteMemory* memory = nullptr);
    /// The avatar does what the source says; the walk's steps are left to the source.
    Simulation(const scene::Campus& campus, const Walk& walk, IntentSource& intents);

    bool finished() const { return finished_; }

    /// Plays one tick; the record is valid until the next call. Tick 0 is the spawn.
    const TickRecord& step();

    /// The last tick again: all contacts end, and then the walk. Call once, when finished.
    const TickRecord& close();

    const std::optional<Stop>& stop() const { return stop_; }
    const ExpectationSet& expectations() const { return state_.expectations; }
    double distance() const { return state_.body.distance(); }
    std::uint64_t hash() const { return hash_.value(); }
    const collision::QueryStatistics& statistics() const { return state_.statistics; }

private:
    void begin_tick(Tick tick);
    Motion move(const Intent& intent);
    void report_motion(const Intent& intent, const Motion& motion);
    void settle_steps();
    void report_step_end(const StepEnd& end);
    void check_timeout();
    void end_tick();
    /// The id of the object that blocks the avatar; empty if none does.
    std::string obstacle() const;
    /// Why the avatar doesn't get on towards `heading`.
    Stop stop_of_fall() const;
    const std::optional<Reason>& reason(const Eigen::Vector3d& heading);

    SimulationState state_;
    BodyRoutes routes_;
    std::optional<ScriptPlayer> script_;  ///< none if the intents come from elsewhere
    IntentSource& intents_;
    std::vector<const Step*> instant_steps_;  ///< a member to reuse its memory
    TickRecord record_;
    /// Where the avatar was last stopped, and why: it is often stuck first and then gives up.
    std::optional<StoppedBody> stopped_;
    std::optional<Reason> stop_reason_;
    bool finished_ = false;
    std::optional<Stop> stop_;
    StateHash hash_;
};

}  // namespace campuswalk::engine
