#include "tools/campuswalk/run/workers/worker_pool.h"

#include <poll.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "engine/events/decimals.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace {

constexpr int kPollInterval = 100;                 // milliseconds between checks of the clock and of Ctrl-C
constexpr std::chrono::seconds kTimeToFinish{10};  // for workers that were told to stop
constexpr std::size_t kMaxWaiting = 100'000;       // tasks that wait for an earlier, slow one

}  // namespace

WorkerPool::WorkerPool(const StartWork& start, std::vector<std::size_t> tasks, PoolListener listener,
                       const PoolSettings& settings)
    : tasks_(std::move(tasks)),
      start_([this, start] {
          return [this, work = start()](std::size_t index, const Send& send) { work(tasks_[index], send); };
      }),
      listener_(std::move(listener)),
      settings_(settings) {}

bool WorkerPool::run() {
    bool wants_more = true;
    while (wants_more && reported_ < tasks_.size()) {
        if (interrupted()) {
            return finish_interrupted();
        }
        hand_out();
        wait_for_answers();
        kill_slow_workers();
        wants_more = report();
        listener_.update_progress();
    }
    workers_.clear();
    return true;
}

/// Tasks are handed out in order, so the one to report next is always done or in progress, and nothing waits
/// for it forever.
void WorkerPool::hand_out() {
    while (next_ < tasks_.size() && pending_.size() < kMaxWaiting) {
        if (buffered_ > settings_.max_buffered && next_ != reported_) {
            return;
        }
        auto idle = std::ranges::find_if(workers_, [](const Worker& worker) { return !worker.task(); });
        if (idle == workers_.end()) {
            if (workers_.size() >= settings_.workers) {
                return;
            }
            workers_.emplace_back(start_, workers_);
            idle = workers_.end() - 1;
        }
        Pending& pending = pending_[next_];
        pending.start = Clock::now();
        if (settings_.kill_after) {
            const std::chrono::duration<double> most(*settings_.kill_after);
            pending.deadline = pending.start + std::chrono::duration_cast<Clock::duration>(most);
        }
        idle->give(next_);
        ++next_;
    }
}

bool WorkerPool::may_read_from(const Worker& worker) const {
    return buffered_ <= settings_.max_buffered || worker.task() == reported_;
}

void WorkerPool::wait_for_answers() {
    std::vector<pollfd> pipes;
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < workers_.size(); ++i) {
        if (may_read_from(workers_[i])) {
            pipes.push_back({workers_[i].answers(), POLLIN, 0});
            whose.push_back(i);
        }
    }
    if (poll(pipes.data(), pipes.size(), kPollInterval) <= 0) {
        return;
    }
    for (std::size_t i = pipes.size(); i-- > 0;) {
        if (pipes[i].revents != 0) {
            read_from(workers_[whose[i]]);
        }
    }
    std::erase_if(workers_, [](const Worker& worker) { return worker.answers() < 0; });
}

void WorkerPool::read_from(Worker& worker) {
    const bool alive = worker.read();
    while (const std::optional<std::size_t> index = worker.task()) {
        std::optional<Message> message = worker.next_message();
        if (!message) {
            break;
        }
        take(*index, std::move(*message));
    }
    if (!alive) {
        const std::optional<std::size_t> index = worker.task();
        const std::string reason = scene::to_string(worker.wait());
        if (index) {
            end_task(*index, {false, "the process that played the walk is gone: " + reason});
        }
    }
}

void WorkerPool::take(std::size_t index, Message message) {
    if (message.topic == Topic::result) {
        end_task(index, {true, std::move(message.body)});
        return;
    }
    buffered_ += message.body.size();
    pending_.at(index).messages.push_back(std::move(message));
}

void WorkerPool::end_task(std::size_t index, Ending ending) {
    Pending& pending = pending_.at(index);
    const auto taken = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - pending.start);
    ending.microseconds = static_cast<std::uint64_t>(taken.count());
    listener_.on_result(tasks_[index], ending);
    buffered_ += ending.text.size();
    pending.ending = std::move(ending);
}

void WorkerPool::kill_slow_workers() {
    if (!settings_.kill_after) {
        return;
    }
    const Clock::time_point now = Clock::now();
    for (Worker& worker : workers_) {
        const std::optional<std::size_t> index = worker.task();
        if (index && now > pending_.at(*index).deadline) {
            worker.send_signal(SIGKILL);
            worker.wait();
            const double most = *settings_.kill_after;
            end_task(*index, {false, "stopped: it took more than " + engine::fixed(most, most < 0.1 ? 3 : 1) +
                                         " s of wall clock (--kill-after)"});
        }
    }
    std::erase_if(workers_, [](const Worker& worker) { return worker.answers() < 0; });
}

bool WorkerPool::report() {
    for (auto first = pending_.begin(); first != pending_.end() && first->first == reported_;
         first = pending_.begin()) {
        const std::size_t task = tasks_[reported_];
        Pending& pending = first->second;
        for (; !pending.messages.empty(); pending.messages.pop_front()) {
            buffered_ -= pending.messages.front().body.size();
            listener_.on_message(task, pending.messages.front().topic, pending.messages.front().body);
        }
        if (!pending.ending) {
            return true;
        }
        const Ending ending = std::move(*pending.ending);
        buffered_ -= ending.text.size();
        pending_.erase(first);
        ++reported_;
        if (!listener_.on_end(task, ending)) {
            return false;
        }
    }
    return true;
}

bool WorkerPool::busy() const {
    return std::ranges::any_of(workers_, [](const Worker& worker) { return worker.task().has_value(); });
}

bool WorkerPool::finish_interrupted() {
    for (const Worker& worker : workers_) {
        worker.send_signal(SIGINT);
    }
    const Clock::time_point end = Clock::now() + kTimeToFinish;
    bool wants_more = true;
    while (wants_more && busy() && Clock::now() < end && !interrupted_again()) {
        wait_for_answers();
        wants_more = report();
    }
    // Also report tasks that finished after one that didn't.
    for (auto& [index, pending] : pending_) {
        if (wants_more && pending.ending) {
            wants_more = listener_.on_end(tasks_[index], *pending.ending);
        }
    }
    workers_.clear();
    return false;
}

}  // namespace campuswalk::tools
