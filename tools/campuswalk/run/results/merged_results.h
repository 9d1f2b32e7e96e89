#pragma once

#include <vector>

#include "tools/campuswalk/run/results/result_file.h"

namespace campuswalk::tools {

/// Calls `visit` for the results of all files in the order in which a single run would have reported them: by
/// file, project and repetition. Each file's own results must be in that order. Of each file only a block is
/// in memory, and it is open only while that is read: there may be more files than a process may open.
/// Throws what ResultFile::for_each throws.
void for_each_merged(const std::vector<const ResultFile*>& files, const ResultVisitor& visit);

/// Whether `a` comes before `b` in a run.
bool comes_before(const engine::WalkResult& a, const engine::WalkResult& b);

}  // namespace campuswalk::tools
