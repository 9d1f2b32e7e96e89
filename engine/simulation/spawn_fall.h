#pragma once

#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// A walk that begins higher above the ground than this begins with a fall, metres.
inline constexpr double kSpawnFall = 0.5;

/// What the walk's own body does at its spawn when it isn't moved.
struct SpawnFall {
    double height =
        0.0;  ///< metres, from the spawn down to where it stands; if it never does, as far as it got
    bool lands = true;  ///< otherwise it falls out of the world, or is held by what can't carry it
};

/// Measured by letting it fall, with every object enabled. Requires a first step `spawn`.
SpawnFall fall_at_spawn(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
