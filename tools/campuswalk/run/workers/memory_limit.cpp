#include "tools/campuswalk/run/workers/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace campuswalk::tools {

namespace {

std::uint64_t page_size() {
    return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Bytes of private writable memory; 0 if the system doesn't tell.
std::uint64_t allocated() {
    std::ifstream statistics("/proc/self/statm");
    std::uint64_t pages = 0;
    constexpr int kData = 6;  // fields: size, resident, shared, text, lib, data
    for (int field = 0; field < kData; ++field) {
        statistics >> pages;
    }
    return statistics ? pages * page_size() : 0;
}

}  // namespace

void limit_worker_memory(std::size_t workers) {
    const std::uint64_t own = allocated();
    if (own == 0) {
        return;
    }
    const std::uint64_t machine = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * page_size();
    const rlim_t most = own + machine / std::max<std::size_t>(workers, 1);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace campuswalk::tools
