#include "engine/render/sequence/frame_queue.h"

namespace campuswalk::engine::render {
namespace {

constexpr std::size_t kCapacity = 4;  // frames per process

}  // namespace

FrameQueue::FrameQueue(std::vector<std::unique_ptr<FrameSink>> sinks, FrameSource* remote_frames,
                       std::size_t parts)
    : sinks_(std::move(sinks)),
      remote_frames_(remote_frames),
      capacity_(kCapacity * parts),
      thread_([this] { work(); }) {}

FrameQueue::~FrameQueue() {
    stop(true);
}

void FrameQueue::push_when_free(Entry entry) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return entries_.size() < capacity_ || failure_; });
    if (failure_) {
        std::rethrow_exception(failure_);
    }
    entries_.push_back(std::move(entry));
    changed_.notify_all();
}

void FrameQueue::finish() {
    stop(false);
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

void FrameQueue::stop(bool discard) {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        if (discard) {
            entries_.clear();
        }
    }
    changed_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
    if (discard || failure_) {
        return;
    }
    for (const std::unique_ptr<FrameSink>& sink : sinks_) {
        sink->finish();
    }
}

void FrameQueue::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return !entries_.empty() || closed_; });
        if (entries_.empty()) {
            return;
        }
        Entry next = std::move(entries_.front());
        entries_.pop_front();
        lock.unlock();
        changed_.notify_all();
        std::exception_ptr failure;
        try {
            deliver(std::move(next));
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) {
            failure_ = failure;
            entries_.clear();
            changed_.notify_all();
            return;
        }
    }
}

void FrameQueue::deliver(Entry entry) {
    const Frame frame = entry.is_remote ? remote_frames_->take(entry.frame.number) : std::move(entry.frame);
    for (const std::unique_ptr<FrameSink>& sink : sinks_) {
        sink->add(frame);
    }
}

}  // namespace campuswalk::engine::render
