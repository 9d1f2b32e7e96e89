#include "tools/campuswalk/run/workers/worker_pool.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <utility>

#include "engine/events/decimals.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPatience = 100;                     // milliseconds between looks at the clock and at Ctrl-C
constexpr std::chrono::seconds kTimeToFinish{10};  // for workers that were asked to stop
constexpr std::size_t kMostEndedEarly = 100'000;   // tasks that wait for a slow one before them

std::optional<Clock::time_point> deadline_after(const std::optional<double>& seconds) {
    if (!seconds) {
        return std::nullopt;
    }
    return Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
}

}  // namespace

WorkerPool::WorkerPool(Work work, const PoolSettings& settings)
    : work_(std::move(work)), settings_(settings) {}

bool WorkerPool::run(const std::vector<std::size_t>& tasks, const PoolListener& listener) {
    tasks_ = &tasks;
    listener_ = &listener;
    next_ = told_ = 0;
    cached_.clear();
    cached_bytes_ = 0;
    bool wanted = true;
    while (wanted && told_ < tasks.size()) {
        if (interrupted()) {
            return wait_out_interrupted();
        }
        hand_out();
        wait_for_answers();
        end_those_too_slow();
        wanted = tell();
        listener.passing_time();
    }
    workers_.clear();
    return true;
}

/// Tasks go out in order, so the one that is to be told of next is always done or being done: whatever waits
/// for it, it can't wait for ever.
void WorkerPool::hand_out() {
    while (next_ < tasks_->size() && cached_.size() < kMostEndedEarly) {
        if (cached_bytes_ > settings_.max_cached && next_ != told_) {
            return;
        }
        auto idle = std::ranges::find_if(workers_, [](const Worker& worker) { return !worker.place(); });
        if (idle == workers_.end()) {
            if (workers_.size() >= settings_.workers) {
                return;
            }
            workers_.emplace_back(work_, workers_);
            idle = workers_.end() - 1;
        }
        cached_.try_emplace(next_);
        idle->give((*tasks_)[next_], next_, deadline_after(settings_.kill_after));
        ++next_;
    }
}

bool WorkerPool::may_listen_to(const Worker& worker) const {
    return cached_bytes_ <= settings_.max_cached || worker.place() == told_;
}

void WorkerPool::wait_for_answers() {
    std::vector<pollfd> pipes;
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < workers_.size(); ++i) {
        if (may_listen_to(workers_[i])) {
            pipes.push_back({workers_[i].answers(), POLLIN, 0});
            whose.push_back(i);
        }
    }
    if (poll(pipes.data(), pipes.size(), kPatience) <= 0) {
        return;
    }
    for (std::size_t i = pipes.size(); i-- > 0;) {  // from the back: the dead are taken out
        if (pipes[i].revents != 0) {
            listen_to(workers_[whose[i]]);
        }
    }
    std::erase_if(workers_, [](const Worker& worker) { return worker.answers() < 0; });
}

void WorkerPool::listen_to(Worker& worker) {
    const bool alive = worker.read();
    while (std::optional<Message> message = worker.next_message()) {
        take(worker, std::move(*message));
    }
    if (!alive) {
        bury(worker);
    }
}

void WorkerPool::take(Worker& worker, Message message) {
    if (!worker.place()) {
        return;
    }
    if (message.topic == Topic::result) {
        end_task(worker, {true, std::move(message.body)});
        return;
    }
    cached_bytes_ += message.body.size();
    cached_.at(*worker.place()).messages.push_back(std::move(message));
}

void WorkerPool::end_task(Worker& worker, Ending ending) {
    const std::size_t place = *worker.place();
    worker.forget_task();
    listener_->ended_first((*tasks_)[place], ending);
    cached_bytes_ += ending.text.size();
    cached_.at(place).ending = std::move(ending);
}

void WorkerPool::bury(Worker& worker) {
    const std::string how = worker.exit_reason();
    if (worker.place()) {
        end_task(worker, {false, "the process that played the walk is gone: " + how});
    }
    worker.hang_up();
}

void WorkerPool::end_those_too_slow() {
    const Clock::time_point now = Clock::now();
    for (Worker& worker : workers_) {
        if (worker.place() && worker.deadline() && now > *worker.deadline()) {
            worker.send_signal(SIGKILL);
            end_task(worker, {false, "stopped: it took more than " +
                                         engine::fixed(settings_.kill_after.value_or(0.0), 1) +
                                         " s of wall clock (--kill-after)"});
            static_cast<void>(worker.exit_reason());
            worker.hang_up();
        }
    }
    std::erase_if(workers_, [](const Worker& worker) { return worker.answers() < 0; });
}

bool WorkerPool::tell() {
    for (auto first = cached_.begin(); first != cached_.end() && first->first == told_;
         first = cached_.begin()) {
        const std::size_t task = (*tasks_)[told_];
        CachedPiece& kept = first->second;
        for (; !kept.messages.empty(); kept.messages.pop_front()) {
            cached_bytes_ -= kept.messages.front().body.size();
            listener_->heard(task, kept.messages.front().topic, kept.messages.front().body);
        }
        if (!kept.ending) {
            return true;
        }
        const Ending ending = std::move(*kept.ending);
        cached_bytes_ -= ending.text.size();
        cached_.erase(first);
        ++told_;
        if (!listener_->ended(task, ending)) {
            return false;
        }
    }
    return true;
}

std::size_t WorkerPool::busy() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(workers_, [](const Worker& worker) { return worker.place().has_value(); }));
}

bool WorkerPool::wait_out_interrupted() {
    for (const Worker& worker : workers_) {
        worker.send_signal(SIGINT);
    }
    const Clock::time_point end = Clock::now() + kTimeToFinish;
    bool wanted = true;
    while (wanted && busy() > 0 && Clock::now() < end && !interrupted_again()) {
        wait_for_answers();
        wanted = tell();
    }
    // Those after one that didn't come to an end, too: they are finished.
    for (auto& [place, kept] : cached_) {
        if (wanted && kept.ending) {
            wanted = listener_->ended((*tasks_)[place], *kept.ending);
        }
    }
    workers_.clear();
    return false;
}

}  // namespace campuswalk::tools
