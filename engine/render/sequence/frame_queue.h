#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/render/sequence/frame_sharing.h"
#include "engine/render/sequence/frame_sink.h"

namespace campuswalk::engine::render {

/// A bounded queue that delivers frames to sinks on its own thread, so that images are compressed while the
/// next one is drawn. In between, remote frames, drawn by other processes, are awaited. `add` blocks while
/// the queue is full.
class FrameQueue {
public:
    /// `remote_frames` supplies all but one of `parts` frames in turn; null if there is one part. Must
    /// outlive this.
    explicit FrameQueue(std::vector<std::unique_ptr<FrameSink>> sinks, FrameSource* remote_frames = nullptr,
                        std::size_t parts = 1);
    /// Without `finish`, pending frames are discarded.
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// Rethrows what a sink or the source threw at an earlier frame.
    void add(Frame frame) { push_when_free({std::move(frame), false}); }
    /// The next frame is remote.
    void add_remote(std::size_t number) { push_when_free({{{}, number, 0.0}, true}); }
    /// Waits for all frames and finishes the sinks. Throws like `add`.
    void finish();

private:
    struct Entry {
        Frame frame;
        bool is_remote = false;  ///< only its number is known yet
    };

    void push_when_free(Entry entry);
    void work();
    void deliver(Entry entry);
    void stop(bool discard);

    std::vector<std::unique_ptr<FrameSink>> sinks_;
    FrameSource* remote_frames_;
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Entry> entries_;
    std::exception_ptr failure_;
    bool closed_ = false;
    std::thread thread_;  // last: it uses the other members
};

}  // namespace campuswalk::engine::render
