#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// How a process ended.
struct ExitStatus {
    int exit_code = 0;
    int signal = 0;  ///< that ended it, 0 for none
    std::uint32_t cpu_seconds = 0;

    bool success() const { return exit_code == 0 && signal == 0; }
};

/// As in "it was ended by signal 11 (Segmentation fault)".
std::string to_string(const ExitStatus& status);

/// A process that this one started. It has to be waited for: the destructor does.
class ChildProcess {
public:
    ChildProcess() = default;
    explicit ChildProcess(pid_t process) : process_(process) {}
    ~ChildProcess() { wait(); }
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;

    /// It has been started and not been waited for.
    bool running() const { return process_ > 0; }
    void send_signal(int signal) const;
    /// Whether it ends within this time; a kernel without pidfd (before 5.3) says yes at once.
    bool ends_within(std::chrono::milliseconds time) const;
    /// Waits until it has ended; without effect when it isn't running.
    ExitStatus wait();

private:
    pid_t process_ = -1;
};

/// A program to be started.
struct ProgramStart {
    std::string program;  ///< looked for in PATH unless it has a slash
    std::vector<std::string> arguments;
    std::vector<std::string> environment;  ///< NAME=VALUE; empty: this process's
    int input = -1;  ///< descriptors that become its standard streams; -1: this process's
    int output = -1;
    int error = -1;
    /// In a process group of its own, so that Ctrl-C is for this process, and with signals as if nobody had
    /// changed what they do.
    bool detached = false;
};

/// Throws std::system_error.
ChildProcess start_program(const ProgramStart& start);

/// Runs `child` in a copy of this process, which ends when that returns, or when this process does. It must
/// throw nothing. Throws std::system_error.
ChildProcess fork_process(const std::function<void()>& child);

}  // namespace campuswalk::scene
