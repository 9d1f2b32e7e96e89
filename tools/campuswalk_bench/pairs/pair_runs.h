#pragma once

#include <vector>

#include "tools/campuswalk_bench/measure/measurement.h"
#include "tools/campuswalk_bench/pairs/pair_engines.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"

namespace campuswalk::tools::bench {

/// Times every query of every engine in every placement (see shuffled_runs.h); a query pays for its move.
/// The right pairs are those of the first engine.
Results measure(const PairScene& scene, const std::vector<NamedEngine>& engines, int rounds);

/// Says what is wrong with our own engines, a line each to standard error. Whether anything is.
bool diagnose_ours(const PairScene& scene, const Results& results);

}  // namespace campuswalk::tools::bench
