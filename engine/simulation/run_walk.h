#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"
#include "engine/events/event.h"
#include "engine/expect/failure.h"
#include "engine/record/observer.h"
#include "engine/script/intent.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

struct WalkSummary {
    bool passed = false;
    Tick ticks = 0;
    std::int64_t events = 0;  ///< events logged between walk.start and walk.end
    double distance = 0.0;    ///< metres, along the path of the foot point
    /// Over the bits of every tick's position and every event, but not over the verdicts: what is expected of
    /// a walk doesn't change it.
    std::uint64_t hash = 0;
    std::vector<Failure> failures;
    collision::QueryStatistics statistics;
};

/// Plays the walk from its first step to its last, evaluates the expectations and shows every frame to the
/// observers, in their order. Deterministic: the same campus and walk give the same frames.
WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, std::span<Observer* const> observers);

/// The same with an avatar that the source moves; of the walk's steps it plays those that the source asks
/// for.
WalkSummary run_walk(const scene::Campus& campus, const Walk& walk, IntentSource& intents,
                     std::span<Observer* const> observers);

}  // namespace campuswalk::engine
