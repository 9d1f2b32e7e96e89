#include "scene/import/helper/helper_exchange.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "scene/process/child_process.h"
#include "scene/process/pipe.h"

namespace campuswalk::scene {
namespace {

[[noreturn]] void cannot_start(int error) {
    throw std::runtime_error("the import process can't be started: " +
                             std::generic_category().message(error));
}

/// An anonymous file in memory. Carries the request and the response; unlike a pipe, neither side can block.
class MemoryFile {
public:
    explicit MemoryFile(const char* name) : file_(memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
        if (!file_.open()) {
            cannot_start(errno);
        }
    }

    int number() const { return file_.number(); }

    void write(std::span<const std::byte> bytes) const {
        if (!write_all(number(), bytes)) {
            cannot_start(errno);
        }
        lseek(number(), 0, SEEK_SET);
    }

    /// Prevents changes by anyone, such as a process that the helper left running; false if one may still
    /// write.
    bool make_read_only() const {
        return fcntl(number(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW) == 0;
    }

private:
    Descriptor file_;
};

/// The bytes of a read-only MemoryFile.
class Mapping {
public:
    explicit Mapping(const MemoryFile& file) {
        struct stat status {};
        if (fstat(file.number(), &status) == 0 && status.st_size > 0) {
            size_ = static_cast<std::size_t>(status.st_size);
            start_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file.number(), 0);
        }
    }
    ~Mapping() {
        if (start_ != MAP_FAILED) {
            munmap(start_, size_);
        }
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    std::span<const std::byte> bytes() const {
        return start_ == MAP_FAILED ? std::span<const std::byte>()
                                    : std::span(static_cast<const std::byte*>(start_), size_);
    }

private:
    void* start_ = MAP_FAILED;
    std::size_t size_ = 0;
};

/// Nothing of ours, which may contain secrets. Large pages are enabled for glibc's malloc: else a third of
/// the time of a large import goes to page faults. Tests under sanitizers need these libraries' options.
std::vector<std::string> helper_environment() {
    std::vector<std::string> variables = {"GLIBC_TUNABLES=glibc.malloc.hugetlb=1"};
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text(*variable);
        if (text.starts_with("ASAN_OPTIONS=") || text.starts_with("UBSAN_OPTIONS=") ||
            text.starts_with("LSAN_OPTIONS=")) {
            variables.emplace_back(text);
        }
    }
    return variables;
}

/// Starts the helper with the request as its standard input and the response as its standard output.
ChildProcess start_helper(const HelperProgram& helper, const MemoryFile& request,
                          const MemoryFile& response) {
    const Descriptor null_device =
        open_null_device();  // a crash is reported in one line, without the helper's output
    try {
        return start_program({.program = helper.program.string(),
                              .arguments = helper.arguments,
                              .environment = helper_environment(),
                              .input = request.number(),
                              .output = response.number(),
                              .error = null_device.number(),
                              .detached = true});
    } catch (const std::system_error& error) {
        cannot_start(error.code().value());
    }
}

std::string in_megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20U) + " MB";
}

/// Why there is no response; empty if there is one.
std::string failure_of(const ExitStatus& end, bool timed_out, const ImportLimits& limits,
                       const HelperAdvice& advice) {
    if (timed_out) {
        return "its import was stopped after " + std::to_string(limits.cpu + limits.waiting) + " s; " +
               advice.if_too_large;
    }
    if (end.signal == SIGXCPU || (end.signal == SIGKILL && end.cpu_seconds >= limits.cpu)) {
        return "its import was stopped after " + std::to_string(limits.cpu) +
               " s of CPU time: it is damaged or too large; " + advice.if_too_large;
    }
    if (end.signal == SIGXFSZ) {
        return "what is made from it exceeds " + in_megabytes(limits.response) + "; " + advice.if_too_large;
    }
    if (end.signal == SIGKILL) {
        return std::string("its import was killed, probably because it ran out of memory; ") +
               advice.if_too_large;
    }
    if (end.signal != 0) {
        return "its reader crashed (signal " + std::to_string(end.signal) +
               "); the file is damaged or uses unsupported features: " + advice.if_unreadable;
    }
    if (end.exit_code != 0) {
        return "its import ended without producing a model (exit code " + std::to_string(end.exit_code) +
               ", perhaps more than " + in_megabytes(limits.memory) + " of memory); " + advice.if_too_large;
    }
    return {};
}

}  // namespace

ImportLimits limits_for(const std::filesystem::path& file, ImportLimits limits) {
    std::error_code ignored;
    const std::uintmax_t bytes = std::filesystem::file_size(file, ignored);
    if (!ignored) {
        const auto megabytes = static_cast<std::uint32_t>(std::min<std::uintmax_t>(bytes >> 20U, 100'000));
        limits.cpu += megabytes * std::min(limits.cpu_per_megabyte, 1000U);
    }
    return limits;
}

HelperResponse ask_helper(const HelperProgram& helper, std::span<const std::byte> request,
                          const ImportLimits& limits, const HelperAdvice& advice) {
    const MemoryFile request_file("campuswalk-import-request");
    const MemoryFile response_file("campuswalk-import-response");
    request_file.write(request);
    ChildProcess process = start_helper(helper, request_file, response_file);
    const std::chrono::seconds time_limit(limits.cpu + limits.waiting);
    const bool timed_out = !process.ends_within(time_limit);
    process.kill_group();  // whatever it may have left running
    HelperResponse response;
    response.failure = failure_of(process.wait(), timed_out, limits, advice);
    if (!response.failure.empty()) {
        return response;
    }
    if (!response_file.make_read_only()) {
        response.failure = "its import left a process running; do not trust this file";
        return response;
    }
    const auto mapping = std::make_shared<const Mapping>(response_file);
    response.bytes = mapping->bytes();
    response.owner = mapping;
    return response;
}

}  // namespace campuswalk::scene
