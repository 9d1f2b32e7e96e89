#pragma once

#include "tools/campuswalk_bench/measure/row.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"

namespace campuswalk::tools::bench {

/// Measures the two meshes of a scene with every engine, except for the variants that are only in Table I,
/// and prints one line per engine.
CaseResult run_pair_case(const PairScene& scene, int rounds);

}  // namespace campuswalk::tools::bench
