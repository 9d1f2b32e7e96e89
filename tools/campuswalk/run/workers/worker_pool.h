#pragma once

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
    std::optional<double> kill_after;                 ///< seconds of wall clock for a task
    std::size_t max_cached = std::size_t{64} << 20U;  ///< bytes of what came too early to be told
};

/// Worker processes that are handed tasks in order, whoever is free. What they say is told in the tasks'
/// order, whatever order they finish in. A worker that dies is replaced and its task has no result.
class WorkerPool {
public:
    WorkerPool(Work work, const PoolSettings& settings);

    /// True when all tasks were told of or `ended` wanted no more, false when interrupted: then those at hand
    /// are given time to come to an end of their own.
    bool run(const std::vector<std::size_t>& tasks, const PoolListener& listener);

private:
    /// What is known of a task that has been handed out and not been told of yet.
    struct CachedPiece {
        std::deque<Message> messages;
        std::optional<Ending> ending;
    };

    void hand_out();
    void wait_for_answers();
    void listen_to(Worker& worker);
    void bury(Worker& worker);
    void end_those_too_slow();
    void take(Worker& worker, Message message);
    void end_task(Worker& worker, Ending ending);
    /// False when the listener wants no more.
    bool tell();
    bool wait_out_interrupted();
    std::size_t busy() const;
    bool may_listen_to(const Worker& worker) const;

    Work work_;
    PoolSettings settings_;
    const std::vector<std::size_t>* tasks_ = nullptr;
    const PoolListener* listener_ = nullptr;
    std::vector<Worker> workers_;
    std::size_t next_ = 0;                       ///< place of the task to hand out next
    std::size_t told_ = 0;                       ///< place of the task to tell of next
    std::map<std::size_t, CachedPiece> cached_;  ///< by place, from `told_` on
    std::size_t cached_bytes_ = 0;
};

}  // namespace campuswalk::tools
