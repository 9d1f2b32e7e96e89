#pragma once

#include <vector>

#include "scene/procedural/table1_scene.h"
#include "tools/campuswalk/bench/measurement.h"
#include "tools/campuswalk/bench/our_engines.h"

namespace campuswalk::tools::bench {

/// Times every query of every engine in every placement, `rounds` times, in one thread. Each round has an
/// order of its own (from a fixed seed), so that a machine that slows down slows all. A run is timed right
/// after one that isn't, with what it needs in the caches; its time includes the move.
///
/// The right pairs are those of the first engine.
Results measure(const scene::Table1Scene& scene, const std::vector<NamedEngine>& engines, int rounds);

}  // namespace campuswalk::tools::bench
