#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// Hands frames to sinks on a thread of its own, so that pictures are compressed while the next one is drawn.
/// A few wait at most: who draws faster than can be written is held up.
class FrameQueue {
public:
    explicit FrameQueue(std::vector<std::unique_ptr<FrameSink>> sinks);
    /// Without `finish` what waits is given up.
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// Throws what a sink threw at an earlier frame.
    void add(Frame frame);
    /// Waits for all of them. Throws what a sink threw.
    void finish();

private:
    void work();
    void stop(bool give_up);

    std::vector<std::unique_ptr<FrameSink>> sinks_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Frame> waiting_;
    std::exception_ptr failure_;
    bool closed_ = false;
    std::thread thread_;  // last: it uses all of the others
};

}  // namespace campuswalk::engine::render
