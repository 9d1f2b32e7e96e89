#include "scene/import/helper/wait_for_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>

namespace campuswalk::scene {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether it ended before `until`.
bool ends_before(int process_file, Clock::time_point until) {
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
        pollfd ended{process_file, POLLIN, 0};
        constexpr std::int64_t kLongest = 60'000;
        const int count = poll(&ended, 1, static_cast<int>(std::clamp<std::int64_t>(left + 1, 0, kLongest)));
        if (count > 0) {
            return true;
        }
        if (left <= 0 || (count < 0 && errno != EINTR)) {
            return false;
        }
    }
}

}  // namespace

Ending wait_for_process(pid_t process, std::uint32_t most_seconds) {
    Ending ending;
    // Debian 12's <sys/pidfd.h> declares it for C only.
    const auto process_file = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
    if (process_file >= 0) {  // else it has no time limit but that of its CPU
        ending.out_of_time = !ends_before(process_file, Clock::now() + std::chrono::seconds(most_seconds));
        close(process_file);
    }
    if (ending.out_of_time) {
        kill(process, SIGKILL);
    }
    int status = 0;
    rusage usage{};
    while (wait4(process, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    ending.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    ending.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    ending.cpu_seconds = static_cast<std::uint32_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
    return ending;
}

}  // namespace campuswalk::scene
