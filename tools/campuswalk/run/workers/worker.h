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

/// What a worker's message is about.
enum class Topic : std::uint8_t {
    log,       ///< lines of the text log
    events,    ///< JSON lines of the log
    progress,  ///< the walk's simulated time in seconds
    frame,     ///< what SequenceSharing::take returns, from a FrameHelpers process
    result,    ///< the last: engine::to_json_line, or the error of a FrameHelpers process
};

struct Message {
    Topic topic = Topic::log;
    std::string body;
};

/// A message as bytes: the topic, the length, the body.
std::string framed(Topic topic, std::string_view body);

/// Reassembles messages from the pieces that come through a pipe.
class MessageReader {
public:
    void add(std::string_view bytes) { bytes_.append(bytes); }
    /// The next complete message; nullopt until more bytes have come. Throws std::runtime_error for bytes
    /// that no worker sends.
    std::optional<Message> next();

private:
    std::string bytes_;
    std::size_t read_ = 0;
};

/// Sends a message about the current task from the worker's process.
using Send = std::function<void(Topic topic, std::string_view body)>;
/// Does a task; must finally send Topic::result. Throws nothing.
using Work = std::function<void(std::size_t task, const Send& send)>;
/// Called once in the worker's process to create what the work needs, which the worker shares with nobody.
using StartWork = std::function<Work()>;

/// A process forked from this one, so that it shares what has been loaded. It gets tasks by number and ends
/// with this object or with this process.
class Worker {
public:
    /// `others` are the existing workers, whose pipes the new one closes. Throws std::runtime_error when no
    /// process can be started.
    Worker(const StartWork& start, const std::vector<Worker>& others);
    ~Worker();
    Worker(Worker&&) noexcept = default;
    Worker& operator=(Worker&&) noexcept = default;

    /// Has no effect on a dead worker, which shows when its answers end.
    void give(std::size_t task);
    /// The current task: given, and its result hasn't been taken yet.
    std::optional<std::size_t> task() const { return task_; }

    /// The pipe to poll; negative once the worker has been waited for.
    int answers() const { return answers_.number(); }
    /// Waits for bytes in the pipe and reads them; false once there will be no more.
    bool read();
    std::optional<Message> next_message();
    /// For callers that wait for nothing else. Throws std::runtime_error when the worker is dead; `what_for`
    /// describes it in the message, as "drew frames" does.
    Message wait_for_message(std::string_view what_for);

    void send_signal(int signal) const { process_.send_signal(signal); }
    /// Waits for its end; from then on it has no task.
    scene::ExitStatus wait();

private:
    scene::ChildProcess process_;
    scene::Descriptor tasks_;
    scene::Descriptor answers_;
    MessageReader reader_;
    std::optional<std::size_t> task_;
};

}  // namespace campuswalk::tools
