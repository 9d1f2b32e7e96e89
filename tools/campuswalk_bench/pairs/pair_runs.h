#pragma once

#include <vector>

#include "tools/campuswalk_bench/measure/measurement.h"
#include "tools/campuswalk_bench/pairs/pair_engines.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"

namespace campuswalk::tools::bench {

/// Times every query of every engine in every placement (see shuffled_runs.h), including set_pose. The first
/// engine's pairs are the reference.
Results measure(const PairScene& scene, const std::vector<NamedEngine>& engines, int rounds);

/// Reports the errors of our own engines, one per line on standard error. Returns whether there are any.
bool report_our_errors(const PairScene& scene, const Results& results);

/// Measures the two meshes of a scene with every engine, except for the variants that are only in Table I,
/// and prints one line per engine.
CaseResult run_pair_case(const PairScene& scene, int rounds);

}  // namespace campuswalk::tools::bench
