#include "engine/walkspace/stride/worker_threads.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <queue>
#include <thread>

namespace campuswalk::engine {

namespace {

/// Tells threads what to work on next.
class Schedule {
public:
    explicit Schedule(const std::vector<std::vector<std::size_t>>& after)
        : awaited_(after.size()), followers_(after.size()), queued_(after.size()), left_(after.size()) {
        for (std::size_t item = after.size(); item-- > 0;) {
            awaited_[item] = after[item].size();
            for (const std::size_t earlier : after[item]) {
                followers_[earlier].push_back(item);
                queued_[earlier] = std::max(queued_[earlier], queued_[item] + 1);
            }
            if (after[item].empty()) {
                add_ready(item);
            }
        }
    }

    /// Of the items that come after nothing that isn't done, once there is one, that which the longest row of
    /// others waits for, then the lowest; none if all are taken.
    std::optional<std::size_t> take() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return left_ == 0 || !ready_.empty(); });
        if (left_ == 0) {
            return std::nullopt;
        }
        const std::size_t item = ready_.top().item;
        ready_.pop();
        if (--left_ == 0) {
            changed_.notify_all();
        }
        return item;
    }

    void note_done(std::size_t item) {
        const std::scoped_lock lock(mutex_);
        for (const std::size_t follower : followers_[item]) {
            if (--awaited_[follower] == 0) {
                add_ready(follower);
                changed_.notify_one();
            }
        }
    }

    void stop() {
        const std::scoped_lock lock(mutex_);
        left_ = 0;
        changed_.notify_all();
    }

private:
    struct Ready {
        std::size_t queued = 0;
        std::size_t item = 0;

        bool operator<(const Ready& other) const {
            return queued != other.queued ? queued < other.queued : item > other.item;
        }
    };

    void add_ready(std::size_t item) { ready_.push({queued_[item], item}); }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::size_t> awaited_;  ///< by item: of those that it comes after, how many aren't done
    std::vector<std::vector<std::size_t>> followers_;  ///< by item
    std::vector<std::size_t> queued_;  ///< by item: the length of the longest row of items that wait for it
    std::priority_queue<Ready> ready_;
    std::size_t left_;  ///< not taken yet
};

}  // namespace

void for_each_item(std::size_t items, std::size_t workers, const ItemWork& work) {
    for_each_item_in_order(std::vector<std::vector<std::size_t>>(items), workers, work);
}

void for_each_item_in_order(const std::vector<std::vector<std::size_t>>& after, std::size_t workers,
                            const ItemWork& work) {
    const std::size_t threads = std::min(after.size(), workers);
    if (threads <= 1) {
        for (std::size_t item = 0; item < after.size(); ++item) {
            work(0, item);
        }
        return;
    }
    Schedule schedule(after);
    std::vector<std::exception_ptr> failures(threads);
    const auto run = [&](std::size_t worker) {
        try {
            while (const auto item = schedule.take()) {
                work(worker, *item);
                schedule.note_done(*item);
            }
        } catch (...) {
            failures[worker] = std::current_exception();
            schedule.stop();
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t worker = 1; worker < threads; ++worker) {
            others.emplace_back(run, worker);
        }
        run(0);
    }
    for (const std::exception_ptr& failure : failures) {
        if (failure) {
            std::rethrow_exception(failure);
        }
    }
}

}  // namespace campuswalk::engine
