#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"
#include "engine/events/event.h"
#include "engine/script/avatar.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// An open information window of a building.
struct OpenPopup {
    std::size_t building = 0;  ///< index into the campus' buildings
    std::string title;         ///< with its variables filled in
    std::string text;
};

/// The collision queries of a tick's stages.
struct TickCosts {
    collision::QueryStatistics move;    ///< placing, sweeping, stepping and sliding
    collision::QueryStatistics detect;  ///< triggers and the gaze
};

/// What happened in a tick, as plain data that observers read afterwards. Spans are valid until the next
/// tick. The walk's last record, with its closing events, repeats the last tick.
struct TickRecord {
    Tick tick = 0;
    double time = 0.0;  ///< seconds: tick / ticks_per_second, never a running sum
    TickCosts costs;
    AvatarState avatar;
    double distance =
        0.0;  ///< metres so far, along the path of the foot point, falls too; teleports add none
    std::size_t steps_over = 0;                      ///< of the walk's steps, at the end of this tick
    std::span<const Event> events;                   ///< in log order
    std::span<const SnapshotStep* const> snapshots;  ///< images that the script takes at the end of this tick
    std::span<const OpenPopup> open_popups;          ///< oldest first
    const std::vector<bool>* disabled = nullptr;     ///< by object; null: none is
};

}  // namespace campuswalk::engine
