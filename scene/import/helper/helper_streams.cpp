#include "scene/import/helper/helper_streams.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "scene/process/pipe.h"

namespace campuswalk::scene {
namespace {

// AddressSanitizer's shadow memory exceeds any limit.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kMayLimitMemory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kMayLimitMemory = false;
#else
constexpr bool kMayLimitMemory = true;
#endif
#else
constexpr bool kMayLimitMemory = true;
#endif

template <typename Resource>
void limit(Resource resource, std::uint64_t soft, std::uint64_t hard) {
    const rlimit both{soft, hard};
    setrlimit(resource, &both);
}

}  // namespace

std::vector<std::byte> read_helper_request() {
    struct stat status {};
    if (fstat(STDIN_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) {
        return {};
    }
    std::vector<std::byte> bytes;
    std::array<std::byte, 4096> part;
    while (const std::size_t got = read_some(STDIN_FILENO, part)) {
        bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(got));
    }
    close(STDIN_FILENO);
    return bytes;
}

void limit_process(const ImportLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // end with the parent
    limit(RLIMIT_CORE, 0, 0);
    constexpr std::uint64_t kMaxFiles = 256;
    limit(RLIMIT_NOFILE, kMaxFiles, kMaxFiles);
    limit(RLIMIT_CPU, limits.cpu, std::uint64_t{limits.cpu} + 1);  // a second between SIGXCPU and SIGKILL
    limit(RLIMIT_FSIZE, limits.response, limits.response);
    if (kMayLimitMemory) {
        limit(RLIMIT_AS, limits.memory, limits.memory);
    }
}

void end_helper(ArchiveWriter& response) {
    for (const std::span<const std::byte> buffer : response.finish()) {
        if (!write_all(STDOUT_FILENO, buffer)) {
            _exit(1);
        }
    }
    _exit(0);  // skips freeing the model
}

}  // namespace campuswalk::scene
