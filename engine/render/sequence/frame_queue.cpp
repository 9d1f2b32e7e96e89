#include "engine/render/sequence/frame_queue.h"

#include <utility>

namespace campuswalk::engine::render {
namespace {

constexpr std::size_t kCapacity = 4;  // images of one's own

}  // namespace

FrameQueue::FrameQueue(std::vector<std::unique_ptr<FrameSink>> sinks, FrameSource* others, std::size_t parts)
    : sinks_(std::move(sinks)), others_(others), capacity_(kCapacity * parts), thread_([this] { work(); }) {}

FrameQueue::~FrameQueue() {
    stop(true);
}

void FrameQueue::push_when_free(Waiting waiting) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < capacity_ || failure_; });
    if (failure_) {
        std::rethrow_exception(failure_);
    }
    waiting_.push_back(std::move(waiting));
    changed_.notify_all();
}

void FrameQueue::finish() {
    stop(false);
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

void FrameQueue::stop(bool give_up) {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        if (give_up) {
            waiting_.clear();
        }
    }
    changed_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
    if (give_up || failure_) {
        return;
    }
    for (const std::unique_ptr<FrameSink>& sink : sinks_) {
        sink->finish();
    }
}

void FrameQueue::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
        if (waiting_.empty()) {
            return;
        }
        Waiting next = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        changed_.notify_all();
        std::exception_ptr failure;
        try {
            hand_over(std::move(next));
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) {
            failure_ = failure;
            waiting_.clear();
            changed_.notify_all();
            return;
        }
    }
}

void FrameQueue::hand_over(Waiting waiting) {
    const Frame frame = waiting.is_remote ? others_->take(waiting.frame.number) : std::move(waiting.frame);
    for (const std::unique_ptr<FrameSink>& sink : sinks_) {
        sink->add(frame);
    }
}

}  // namespace campuswalk::engine::render
