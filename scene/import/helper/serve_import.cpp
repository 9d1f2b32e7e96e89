#include "scene/import/helper/serve_import.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>

#include "scene/import/source/scene_folder.h"
#include "scene/model/model_file.h"
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

std::vector<std::byte> read_all(int from) {
    std::vector<std::byte> bytes;
    std::array<std::byte, 4096> part;
    while (const std::size_t got = read_some(from, part)) {
        bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(got));
    }
    return bytes;
}

bool write_response(int to, const ImportedModel& response) {
    ArchiveWriter file = archive_model(response);
    for (const std::span<const std::byte> buffer : file.finish()) {
        if (!write_all(to, buffer)) {
            return false;
        }
    }
    return true;
}

ImportedModel response_to(const ImportRequest& request) {
    try {
        return import_model(request.file, request.if_empty);
    } catch (const InputError& error) {
        return error_response(error);
    }
}

}  // namespace

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

int serve_import() {
    struct stat status {};
    if (fstat(STDIN_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) {
        return 2;  // started by hand
    }
    try {
        const ImportRequest request = read_request(read_all(STDIN_FILENO));
        limit_process(request.limits);
        close(STDIN_FILENO);
        enter_sandbox(SceneFolder(request.file).readable_paths(), request.sandbox);
        _exit(write_response(STDOUT_FILENO, response_to(request)) ? 0 : 1);  // skips freeing the model
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace campuswalk::scene
