#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campuswalk/run/workers/worker.h"

namespace campuswalk::tools {

/// How a task ended.
struct Ending {
    bool answered = false;  ///< `text` is the worker's result; else why there is none
    std::string text;
    std::uint64_t microseconds = 0;  ///< of wall clock since it was handed out
};

/// Callbacks of a pool's owner. All but the first and the last are called in the order of the tasks, each
/// task's `on_message` before its `on_end`.
struct PoolListener {
    std::function<void(std::size_t task, const Ending&)> on_result;  ///< at once, in any order
    std::function<void(std::size_t task, Topic, std::string_view body)> on_message;
    std::function<bool(std::size_t task, const Ending&)> on_end;  ///< false: skip the other tasks
    std::function<void()> update_progress;                        ///< several times a second
};

struct PoolSettings {
    std::size_t workers = 1;
    std::optional<double> kill_after;                   ///< seconds of wall clock for a task
    std::size_t max_buffered = std::size_t{64} << 20U;  ///< bytes of messages that can't be reported yet
};

/// Worker processes. Whichever is idle gets the next task; messages are reported in the order of the tasks,
/// in whatever order these finish. A worker that dies is replaced, and its task has no result.
class WorkerPool {
public:
    WorkerPool(const StartWork& start, std::vector<std::size_t> tasks, PoolListener listener,
               const PoolSettings& settings);
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// To be called once. True when all tasks were reported or `on_end` returned false; false when
    /// interrupted, which gives the current tasks some time to finish.
    bool run();

private:
    using Clock = std::chrono::steady_clock;

    /// A task that has been handed out but not reported yet.
    struct Pending {
        std::deque<Message> messages;
        std::optional<Ending> ending;
        Clock::time_point start;
        Clock::time_point deadline;
    };

    void hand_out();
    void wait_for_answers();
    void read_from(Worker& worker);
    void kill_slow_workers();
    void take(std::size_t index, Message message);
    void end_task(std::size_t index, Ending ending);
    /// False when the listener wants no more tasks.
    bool report();
    bool finish_interrupted();
    bool busy() const;
    bool may_read_from(const Worker& worker) const;

    // Workers get a task as its index in this list.
    std::vector<std::size_t> tasks_;
    StartWork start_;
    PoolListener listener_;
    PoolSettings settings_;
    std::vector<Worker> workers_;
    std::size_t next_ = 0;                    ///< index of the task to hand out next
    std::size_t reported_ = 0;                ///< index of the task to report next
    std::map<std::size_t, Pending> pending_;  ///< by index, from `reported_` on
    std::size_t buffered_ = 0;                ///< bytes in `pending_`
};

}  // namespace campuswalk::tools
