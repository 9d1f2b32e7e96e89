#include "scene/import/helper/limit_process.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <csignal>

namespace campuswalk::scene {
namespace {

// An address sanitizer's shadow alone is larger than any limit.
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

void limit_process(const ImportLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // who asked is gone: nobody wants the answer
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_CPU, limits.cpu, std::uint64_t{limits.cpu} + 1);  // a second between SIGXCPU and SIGKILL
    limit(RLIMIT_FSIZE, limits.answer, limits.answer);
    if (kMayLimitMemory) {
        limit(RLIMIT_AS, limits.memory, limits.memory);
    }
}

}  // namespace campuswalk::scene
