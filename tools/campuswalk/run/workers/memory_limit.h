#pragma once

#include <cstddef>

namespace campuswalk::tools {

/// Limits what this process may allocate from now on, beyond what it shares with its parent, to its part of
/// the machine's memory: a walk that exhausts the memory must not end those of other workers.
/// Counts private writable memory (RLIMIT_DATA), not the address space that drivers reserve.
void limit_worker_memory(std::size_t workers);

}  // namespace campuswalk::tools
