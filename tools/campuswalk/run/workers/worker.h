#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campuswalk/run/workers/messages.h"

namespace campuswalk::tools {

/// A file descriptor that is closed in the end.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Descriptor& operator=(Descriptor&& other) noexcept;

    int number() const { return number_; }
    void close();

private:
    int number_;
};

/// How a worker, in its process, says something about the task at hand.
using Say = std::function<void(Topic topic, std::string_view body)>;
/// What a worker does, in its process; must end by saying Topic::result. Throws nothing.
using Work = std::function<void(std::size_t task, const Say& say)>;

/// A process forked from this one, so that it shares what has been loaded. It is given tasks by number and
/// ends when this object does, or with this process.
class Worker {
public:
    /// `others` are workers that there are already: their pipes are none of the new one's business. Throws
    /// std::runtime_error when the system has no room.
    Worker(const Work& work, const std::vector<Worker>& others);
    ~Worker();
    Worker(Worker&& other) noexcept;
    Worker& operator=(Worker&& other) noexcept;

    /// Without effect on one that is dead; that shows when its answers end.
    /// `place` is the caller's name for the task.
    void give(std::size_t task, std::size_t place,
              std::optional<std::chrono::steady_clock::time_point> deadline);
    void forget_task() { place_.reset(); }
    /// Of the task at hand.
    std::optional<std::size_t> place() const { return place_; }
    std::optional<std::chrono::steady_clock::time_point> deadline() const { return deadline_; }

    int answers() const { return answers_.number(); }
    /// Takes in what the pipe holds; false once there will be no more.
    bool read();
    std::optional<Message> next_message() { return reader_.next(); }
    /// For those who have nothing else to listen to. Throws std::runtime_error, once, when it is dead;
    /// `what_for` says of it what "drew frames" would.
    Message wait_for_message(std::string_view what_for);

    void send_signal(int signal) const;
    /// It is dead and will not be asked again.
    void hang_up();
    /// Waits for its end; how it ended, as in "it was ended by signal 11 (Segmentation fault)".
    std::string exit_reason();

private:
    [[noreturn]] void serve(const Work& work, int tasks, int answers, pid_t parent) const;
    void end();

    pid_t process_ = -1;
    Descriptor tasks_;
    Descriptor answers_;
    MessageReader reader_;
    std::optional<std::size_t> place_;
    std::optional<std::chrono::steady_clock::time_point> deadline_;
};

}  // namespace campuswalk::tools
