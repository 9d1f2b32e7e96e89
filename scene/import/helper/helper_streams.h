#pragma once

#include <cstddef>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/import/helper/import_limits.h"

namespace campuswalk::scene {

// What every helper process does, before and after its own task.

/// All of standard input, which is closed; empty if it isn't a file: somebody started the helper by hand.
std::vector<std::byte> read_helper_request();

/// Limits the resources of this process, except wall clock time, which the parent watches.
void limit_process(const ImportLimits& limits);

/// Writes the response to standard output and ends the process: with 0 if all of it was written, else 1.
[[noreturn]] void end_helper(ArchiveWriter& response);

}  // namespace campuswalk::scene
