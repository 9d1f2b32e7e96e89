#pragma once

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// What trees cost, ours and FCL's, on the two meshes of Table I together: case `build`, microseconds a
/// triangle, and case `memory`, bytes a triangle. Queries of `memory`: heap_bytes, all that stays allocated
/// for mesh and tree, counted in the same way for all; of ours data_bytes, mesh and tree by their sizes, and
/// tree_bytes, the tree alone.
CaseResult run_tree_cases(int rounds);

}  // namespace campuswalk::tools::bench
