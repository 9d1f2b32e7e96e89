#include "tools/campuswalk/run/results/background_reporter.h"

#include <pthread.h>

#include <atomic>
#include <csignal>
#include <utility>

namespace campuswalk::tools {

namespace {

constexpr std::size_t kMostWaiting = 64;
constexpr std::size_t kAtOnce = 16;  // to wake the thread for each result takes longer than to write most

/// Held while a thread of ours works, and while this process forks.
std::mutex& busy() {
    static std::mutex mutex;
    return mutex;
}

/// Whether a fork waits: mutexes aren't fair, and the thread would take it again at once.
std::atomic<bool> fork_waits = false;

void fork_only_between_results() {
    static const int registered = pthread_atfork(
        [] {
            fork_waits = true;
            busy().lock();
            fork_waits = false;
        },
        [] { busy().unlock(); }, [] { busy().unlock(); });
    static_cast<void>(registered);
}

}  // namespace

BackgroundReporter::BackgroundReporter(std::unique_ptr<engine::Reporter> reporter)
    : reporter_(std::move(reporter)) {
    fork_only_between_results();
}

BackgroundReporter::~BackgroundReporter() {
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();  // after end() nothing waits; without it, nobody wants the rest
    }
    stop();
}

void BackgroundReporter::begin(const engine::RunPlan& plan) {
    reporter_->begin(plan);
}

void BackgroundReporter::result(const engine::WalkResult& result) {
    start();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || failure_; });
    throw_if_failed();
    waiting_.push_back(result);
    if (waiting_.size() % kAtOnce == 0) {
        changed_.notify_all();
    }
}

void BackgroundReporter::end(const engine::ResultSequence& results) {
    stop();
    throw_if_failed();
    reporter_->end(results);
}

/// At the first result: usually all workers have been forked by then.
void BackgroundReporter::start() {
    if (thread_.joinable()) {
        return;
    }
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);  // signals are for the thread that waits for them
    thread_ = std::thread([this] { work(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

void BackgroundReporter::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
        if (waiting_.empty() || failure_) {
            return;
        }
        const engine::WalkResult result = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        while (fork_waits) {
            std::this_thread::yield();
        }
        {
            const std::lock_guard working(busy());
            try {
                reporter_->result(result);
            } catch (...) {
                lock.lock();
                failure_ = std::current_exception();
                lock.unlock();
            }
        }
        lock.lock();
        changed_.notify_all();
    }
}

void BackgroundReporter::stop() {
    if (thread_.joinable()) {
        {
            const std::lock_guard lock(mutex_);
            closed_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }
}

void BackgroundReporter::throw_if_failed() {
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

}  // namespace campuswalk::tools
