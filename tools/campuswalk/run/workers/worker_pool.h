#pragma once

#include <chrono>
#include <cstddef>
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
};

/// What a pool's owner does with what comes in. All but the first and the last are called in the order of
/// the tasks, each task's `heard` before its `ended`.
struct PoolListener {
    std::function<void(std::size_t task, const Ending&)> ended_first;  ///< as it comes, to be kept
    std::function<void(std::size_t task, Topic, std::string_view body)> heard;
    std::function<bool(std::size_t task, const Ending&)> ended;  ///< false: enough, leave out the rest
    std::function<void()> passing_time;                          ///< several times a second
};

struct PoolSettings {
    std::size_t workers = 1;
    std::optional<double> kill_after;                    ///< seconds of wall clock for a task
    std::size_t most_buffered = std::size_t{64} << 20U;  ///< bytes of what came too early to be reported
};

/// Worker processes that are handed tasks in order, whoever is free. What they say is reported in the tasks'
/// order, whatever order they finish in. A worker that dies is replaced and its task has no result.
class WorkerPool {
public:
    WorkerPool(const StartWork& start, std::vector<std::size_t> tasks, PoolListener listener,
               const PoolSettings& settings);
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// Once. True when all tasks were reported or `ended` wanted no more, false when interrupted: then those
    /// at hand are given time to come to an end of their own.
    bool run();

private:
    using Clock = std::chrono::steady_clock;

    /// A task that has been handed out and not been reported yet.
    struct Pending {
        std::deque<Message> messages;
        std::optional<Ending> ending;
        Clock::time_point deadline;
    };

    void hand_out();
    void wait_for_answers();
    void listen_to(Worker& worker);
    void end_those_too_slow();
    void take(std::size_t place, Message message);
    void end_task(std::size_t place, Ending ending);
    /// False when the listener wants no more.
    bool report();
    bool wait_out_interrupted();
    bool busy() const;
    bool may_listen_to(const Worker& worker) const;

    // Workers know a task by its place among these.
    std::vector<std::size_t> tasks_;
    StartWork start_;
    PoolListener listener_;
    PoolSettings settings_;
    std::vector<Worker> workers_;
    std::size_t next_ = 0;                    ///< place of the task to hand out next
    std::size_t reported_ = 0;                ///< place of the task to report next
    std::map<std::size_t, Pending> pending_;  ///< by place, from `reported_` on
    std::size_t buffered_ = 0;                ///< bytes in `pending_`
};

}  // namespace campuswalk::tools
