#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/process/child_process.h"
#include "scene/process/pipe.h"

namespace campuswalk::tools {

/// What a worker says about its task.
enum class Topic : std::uint8_t {
    log,     ///< lines of the text log
    events,  ///< lines of the log as JSON
    place,   ///< the walk's time in seconds, for people to see
    frame,   ///< what SequenceSharing::take gives, from one that helps to draw
    result,  ///< the last: engine::to_json_line, or of one that helps to draw what went wrong
};

struct Message {
    Topic topic = Topic::log;
    std::string body;
};

/// As bytes: the topic, the length, the body.
std::string framed(Topic topic, std::string_view body);

/// Puts messages together again from whatever pieces a pipe gives.
class MessageReader {
public:
    void add(std::string_view bytes) { bytes_.append(bytes); }
    /// The next one that is whole; nullopt until more has come. Throws std::runtime_error for what no worker
    /// sends.
    std::optional<Message> next();

private:
    std::string bytes_;
    std::size_t read_ = 0;
};

/// How a worker, in its process, says something about the task at hand.
using Say = std::function<void(Topic topic, std::string_view body)>;
/// Does a task; must end by saying Topic::result. Throws nothing.
using Work = std::function<void(std::size_t task, const Say& say)>;
/// Called once in the worker's process: what the work needs is made there, and is nobody else's.
using StartWork = std::function<Work()>;

/// A process forked from this one, so that it shares what has been loaded. It is given tasks by number and
/// ends when this object does, or with this process.
class Worker {
public:
    /// `others` are workers that there are already: their pipes are none of the new one's business. Throws
    /// std::runtime_error when the system has no room.
    Worker(const StartWork& start, const std::vector<Worker>& others);
    ~Worker();
    Worker(Worker&&) noexcept = default;
    Worker& operator=(Worker&&) noexcept = default;

    /// Without effect on one that is dead; that shows when its answers end.
    void give(std::size_t task);
    /// The one at hand: given, and its result hasn't been taken yet.
    std::optional<std::size_t> task() const { return task_; }

    /// To be polled; negative once it has been waited for.
    int answers() const { return answers_.number(); }
    /// Takes in what the pipe holds, of which it waits for some; false once there will be no more.
    bool read();
    std::optional<Message> next_message();
    /// For those who have nothing else to listen to. Throws std::runtime_error when it is dead; `what_for`
    /// says of it what "drew frames" would.
    Message wait_for_message(std::string_view what_for);

    void send_signal(int signal) const { process_.send_signal(signal); }
    /// Waits for its end; it has no task from now on.
    scene::ExitStatus wait();

private:
    scene::ChildProcess process_;
    scene::Descriptor tasks_;
    scene::Descriptor answers_;
    MessageReader reader_;
    std::optional<std::size_t> task_;
};

}  // namespace campuswalk::tools
