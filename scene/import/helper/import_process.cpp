#include "scene/import/helper/import_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/import/helper/wait_for_process.h"

namespace campuswalk::scene {
namespace {

[[noreturn]] void cannot_start(int error) {
    throw std::runtime_error("the import process can't be started: " +
                             std::generic_category().message(error));
}

/// A file that lives in memory and has no name: requests and answers go through it, so that neither side
/// waits for the other.
class MemoryFile {
public:
    explicit MemoryFile(const char* name) : number_(memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
        if (number_ < 0) {
            cannot_start(errno);
        }
    }
    ~MemoryFile() { close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int number() const { return number_; }

    void write(std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(number_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR) {
                cannot_start(errno);
            }
            bytes = bytes.subspan(written > 0 ? static_cast<std::size_t>(written) : 0);
        }
        lseek(number_, 0, SEEK_SET);
    }

    /// Nobody changes it any more, not even a process that the helper left behind; false if one still could.
    bool finish() const {
        return fcntl(number_, F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW) == 0;
    }

private:
    int number_;
};

/// The bytes of a sealed MemoryFile.
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

/// Ours, but that glibc's malloc is told to take large pages: a large model's import waits a third of its
/// time for small ones.
std::vector<std::string> helper_variables() {
    constexpr std::string_view kTunables = "GLIBC_TUNABLES=";
    constexpr std::string_view kLargePages = "glibc.malloc.hugetlb=1";
    std::vector<std::string> variables;
    std::string tunables = std::string(kTunables) + std::string(kLargePages);
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text(*variable);
        if (text.starts_with(kTunables)) {
            tunables += ":" + std::string(text.substr(kTunables.size()));
        } else {
            variables.emplace_back(text);
        }
    }
    variables.push_back(std::move(tunables));
    return variables;
}

/// The attributes and file actions of one start.
class SpawnPlan {
public:
    SpawnPlan(const MemoryFile& request, const MemoryFile& answer) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, request.number(), STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, answer.number(), STDOUT_FILENO);
        // What a crash prints is nobody's business: it is told in one line.
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawnattr_init(&attributes_);
        // A group of its own: Ctrl-C is for us, and our end ends the helper.
        posix_spawnattr_setflags(
            &attributes_,
            static_cast<short>(POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
        posix_spawnattr_setpgroup(&attributes_, 0);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes_, &signals);
        for (const int signal : {SIGXCPU, SIGXFSZ, SIGPIPE, SIGTERM}) {
            sigaddset(&signals, signal);
        }
        posix_spawnattr_setsigdefault(&attributes_, &signals);
    }
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    pid_t start(const HelperProgram& helper) const {
        std::string name = helper.program.string();
        std::vector<std::string> words = helper.arguments;
        std::vector<char*> arguments = {name.data()};
        for (std::string& word : words) {
            arguments.push_back(word.data());
        }
        arguments.push_back(nullptr);
        std::vector<std::string> variables = helper_variables();
        std::vector<char*> environment;
        environment.reserve(variables.size() + 1);
        for (std::string& variable : variables) {
            environment.push_back(variable.data());
        }
        environment.push_back(nullptr);
        pid_t process = 0;
        const int error = posix_spawn(&process, name.c_str(), &actions_, &attributes_, arguments.data(),
                                      environment.data());
        if (error != 0) {
            cannot_start(error);
        }
        return process;
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// With the file's size taken into account.
ImportLimits limits_for(const SceneFile& file, ImportLimits limits) {
    std::error_code none;
    const std::uintmax_t bytes = std::filesystem::file_size(file.path, none);
    if (!none) {
        const auto megabytes = static_cast<std::uint32_t>(std::min<std::uintmax_t>(bytes >> 20U, 100'000));
        limits.cpu += megabytes * std::min(limits.cpu_per_megabyte, 1000U);
    }
    return limits;
}

std::string in_megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20U) + " MB";
}

/// Why there is no answer, in words; empty when there should be one.
std::string trouble_of(const Ending& ending, const ImportLimits& limits) {
    if (ending.out_of_time) {
        return "its import was stopped after " + std::to_string(limits.cpu + limits.waiting) +
               " s; re-export, simplify or split it";
    }
    if (ending.signal == SIGXCPU || (ending.signal == SIGKILL && ending.cpu_seconds >= limits.cpu)) {
        return "its import was stopped after " + std::to_string(limits.cpu) +
               " s of CPU time: it is damaged or too large; re-export, simplify or split it";
    }
    if (ending.signal == SIGXFSZ) {
        return "the imported model exceeds " + in_megabytes(limits.answer) + "; simplify or split it";
    }
    if (ending.signal == SIGKILL) {
        return "its import was killed, probably because it ran out of memory; simplify or split it";
    }
    if (ending.signal != 0) {
        return "its reader crashed (signal " + std::to_string(ending.signal) +
               "); the file is damaged or uses unsupported features: convert it to glTF";
    }
    if (ending.exit_code != 0) {
        return "its import ended without producing a model (exit code " + std::to_string(ending.exit_code) +
               ", perhaps more than " + in_megabytes(limits.memory) + " of memory); simplify or split it";
    }
    return {};
}

ImportedModel import_with(const HelperProgram& helper, const ImportRequest& request) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(request.file.mark, "bad-model", "'" + request.file.file + "' can't be read: " + why);
    };
    const MemoryFile question("campuswalk-import-request");
    const MemoryFile answer("campuswalk-import-answer");
    question.write(write_request(request));
    const pid_t process = SpawnPlan(question, answer).start(helper);
    const std::string trouble =
        trouble_of(wait_for_process(process, request.limits.cpu + request.limits.waiting), request.limits);
    if (!trouble.empty()) {
        refuse(trouble);
    }
    if (!answer.finish()) {
        refuse("its import left a process running; do not trust this file");
    }
    try {
        const auto mapping = std::make_shared<const Mapping>(answer);
        return read_answer(mapping->bytes(), mapping);
    } catch (const DamagedFile& damage) {
        refuse(std::string("its import returned invalid data (") + damage.what() +
               "); do not trust this file");
    }
    return {};
}

}  // namespace

Importer import_in_process(HelperProgram helper, ImportLimits limits) {
    return [helper = std::move(helper), limits](const SceneFile& file, EmptyModel if_empty) {
        return import_with(helper, {file, if_empty, limits_for(file, limits)});
    };
}

}  // namespace campuswalk::scene
