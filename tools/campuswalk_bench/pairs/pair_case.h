#pragma once

#include "tools/campuswalk_bench/measure/row.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"

namespace campuswalk::tools::bench {

/// Holds the two meshes of a scene against each other by every engine but the variants that Table I alone is
/// about, and prints a line an engine.
CaseResult run_pair_case(const PairScene& scene, int rounds);

}  // namespace campuswalk::tools::bench
