#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/base/query_statistics.h"
#include "engine/events/event.h"
#include "engine/expect/expectation_set.h"
#include "engine/expect/failure.h"
#include "engine/record/observer.h"
#include "engine/script/intent.h"
#include "engine/script/walk.h"
#include "engine/simulation/route_memory.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

struct WalkSummary {
    bool passed = false;
    Tick ticks = 0;
    std::int64_t events = 0;  ///< events logged between walk.start and walk.end
    double distance = 0.0;    ///< metres, along the path of the foot point
    /// Of the bits of every tick's position and every event, but not of the verdicts: a walk's expectations
    /// don't change it.
    std::uint64_t hash = 0;
    std::vector<Failure> failures;
    /// What the rest of a walk that a step or its timeout stopped might have decided otherwise; empty if it
    /// got to its end.
    std::vector<Undecided> undecided;
    collision::QueryStatistics statistics;
};

/// Plays the walk from its first step to its last, evaluates the expectations and passes each tick record to
/// the observers, in their order. Deterministic: the same campus and walk produce the same records.
/// `memory` may be null.
WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, std::span<Observer* const> observers,
                     RouteMemory* memory = nullptr);

/// The same with an avatar that `intents` moves; of the walk's steps only those that it returns are executed.
WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, IntentSource& intents,
                     std::span<Observer* const> observers);

}  // namespace campuswalk::engine
