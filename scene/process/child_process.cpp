#include "scene/process/child_process.h"

#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "scene/process/pipe.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace campuswalk::scene {
namespace {

/// The attributes and file actions for posix_spawn.
class SpawnSettings {
public:
    explicit SpawnSettings(const ProgramStart& start) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        const std::pair<int, int> streams[] = {
            {start.input, STDIN_FILENO}, {start.output, STDOUT_FILENO}, {start.error, STDERR_FILENO}};
        for (const auto& [from, to] : streams) {
            if (from >= 0) {
                posix_spawn_file_actions_adddup2(&actions_, from, to);
            }
        }
        if (start.detached) {
            detach();
        }
    }
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    const posix_spawn_file_actions_t* actions() const { return &actions_; }
    const posix_spawnattr_t* attributes() const { return &attributes_; }

private:
    void detach() {
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

    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// The null-terminated array that exec expects. `words` must outlive it.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace

std::string to_string(const ExitStatus& status) {
    return status.signal != 0 ? "it was ended by signal " + std::to_string(status.signal) + " (" +
                                    strsignal(status.signal) + ")"
                              : "it ended with code " + std::to_string(status.exit_code);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : process_(std::exchange(other.process_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(process_, other.process_);
    return *this;
}

void ChildProcess::send_signal(int signal) const {
    if (running()) {
        kill(process_, signal);
    }
}

void ChildProcess::kill_group() const {
    if (running()) {
        kill(-process_, SIGKILL);
    }
}

bool ChildProcess::ends_within(std::chrono::milliseconds time) const {
    using Clock = std::chrono::steady_clock;
    // Debian 12's <sys/pidfd.h> declares it for C only.
    const Descriptor process(running() ? static_cast<int>(syscall(SYS_pidfd_open, process_, 0)) : -1);
    if (!process.open()) {
        siginfo_t ignored{};
        while (running() && waitid(P_PID, static_cast<id_t>(process_), &ignored, WEXITED | WNOWAIT) < 0 &&
               errno == EINTR) {
        }
        return true;
    }
    const Clock::time_point until = Clock::now() + time;
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
        pollfd ended{process.number(), POLLIN, 0};
        constexpr std::int64_t kMaxWait = 60'000;  // milliseconds
        const int count = poll(&ended, 1, static_cast<int>(std::clamp<std::int64_t>(left + 1, 0, kMaxWait)));
        if (count > 0) {
            return true;
        }
        if (left <= 0 || (count < 0 && errno != EINTR)) {
            return false;
        }
    }
}

ExitStatus ChildProcess::wait() {
    if (!running()) {
        return {};
    }
    int status = 0;
    rusage usage{};
    while (wait4(process_, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 0, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
            static_cast<std::uint32_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)};
}

ChildProcess start_program(const ProgramStart& start) {
    std::vector<std::string> words = {start.program};
    words.insert(words.end(), start.arguments.begin(), start.arguments.end());
    std::vector<std::string> variables = start.environment;
    const SpawnSettings settings(start);
    pid_t process = -1;
    const int error =
        posix_spawnp(&process, start.program.c_str(), settings.actions(), settings.attributes(),
                     pointers_to(words).data(), variables.empty() ? environ : pointers_to(variables).data());
    if (error != 0) {
        throw std::system_error(error, std::generic_category());
    }
    return ChildProcess(process);
}

ChildProcess fork_process(const std::function<void()>& child) {
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process < 0) {
        throw std::system_error(errno, std::generic_category(), "no process can be started");
    }
    if (process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() == parent) {  // otherwise it ended before the prctl above
            child();
        }
        _exit(0);
    }
    return ChildProcess(process);
}

}  // namespace campuswalk::scene
