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

/// A building's information window as it has opened.
struct OpenPopup {
    std::size_t building = 0;  ///< index into the campus' buildings
    std::string title;         ///< with its variables filled in
    std::string text;
};

/// The work of a tick's stages, in tests of pairs.
struct TickCosts {
    collision::QueryStatistics move;    ///< putting down, sweeping, stepping and sliding
    collision::QueryStatistics detect;  ///< triggers and the look
};

/// What one tick did, as plain data that observers read after it. Spans stay valid until the next tick.
struct TickRecord {
    Tick tick = 0;
    double time = 0.0;  ///< seconds: tick / ticks_per_second, never a running sum
    TickCosts costs;
    AvatarState avatar;
    double distance = 0.0;                           ///< metres so far, along the path of the foot point
    std::span<const Event> events;                   ///< in log order
    std::span<const SnapshotStep* const> snapshots;  ///< images the script asks for at this moment
    std::span<const OpenPopup> open_popups;          ///< oldest first
    const std::vector<bool>* disabled = nullptr;     ///< by object; null: none is
};

}  // namespace campuswalk::engine
