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
    int signal = 0;  ///< that ended it; 0 if none did
    std::uint32_t cpu_seconds = 0;

    bool success() const { return exit_code == 0 && signal == 0; }
};

/// Such as "it was ended by signal 11 (Segmentation fault)".
std::string to_string(const ExitStatus& status);

/// A process that this one started. The destructor waits for its end.
class ChildProcess {
public:
    ChildProcess() = default;
    explicit ChildProcess(pid_t process) : process_(process) {}
    ~ChildProcess() { wait(); }
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;

    /// Whether it has been started and not yet been waited for.
    bool running() const { return process_ > 0; }
    void send_signal(int signal) const;
    /// Ends a detached process and those that it has started; to be called before wait().
    void kill_group() const;
    /// Whether it ends within this time; however long it takes on a kernel without pidfd (before 5.3).
    bool ends_within(std::chrono::milliseconds time) const;
    /// Waits until it has ended; does nothing if it isn't running.
    ExitStatus wait();

private:
    pid_t process_ = -1;
};

/// A program to be started.
struct ProgramStart {
    std::string program;  ///< looked up in PATH unless it contains a slash
    std::vector<std::string> arguments;
    std::vector<std::string> environment;  ///< NAME=VALUE; empty: this process's
    int input = -1;  ///< descriptors that become its standard streams; -1: this process's
    int output = -1;
    int error = -1;
    /// In a new process group, so that Ctrl-C reaches only this process, and with default signal handling.
    bool detached = false;
};

/// Throws std::system_error.
ChildProcess start_program(const ProgramStart& start);

/// Runs `child` in a copy of this process, which ends when `child` returns or when this process ends. `child`
/// must not throw. Throws std::system_error.
ChildProcess fork_process(const std::function<void()>& child);

}  // namespace campuswalk::scene
