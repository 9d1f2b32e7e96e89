#pragma once

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// The costs of trees, ours and FCL's, on the two meshes of Table I together: case `build`, microseconds per
/// triangle, and case `memory`, bytes per triangle. Queries of `memory`: heap_bytes, all that stays allocated
/// for mesh and tree, counted in the same way for all; for ours also data_bytes, mesh and tree by their
/// sizes, and tree_bytes, the tree alone.
CaseResult run_tree_cases(int rounds);

}  // namespace campuswalk::tools::bench
