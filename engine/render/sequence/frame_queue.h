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

/// Hands frames to sinks on a thread of its own, so that images are compressed while the next one is drawn,
/// and those that others draw are waited for. A few wait at most: who draws faster than can be written is
/// held up.
class FrameQueue {
public:
    /// `others` draw all but one of `parts` frames in turn, and must outlive this; null when there are none.
    explicit FrameQueue(std::vector<std::unique_ptr<FrameSink>> sinks, FrameSource* others = nullptr,
                        std::size_t parts = 1);
    /// Without `finish` what waits is given up.
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// Throws what a sink or the others threw at an earlier frame.
    void add(Frame frame) { push_when_free({std::move(frame), false}); }
    /// The next is one that the others draw.
    void add_remote(std::size_t number) { push_when_free({{{}, number, 0.0}, true}); }
    /// Waits for all of them. Throws likewise.
    void finish();

private:
    struct Waiting {
        Frame frame;
        bool is_remote = false;  ///< of which only the number is known
    };

    void push_when_free(Waiting waiting);
    void work();
    void hand_over(Waiting waiting);
    void stop(bool give_up);

    std::vector<std::unique_ptr<FrameSink>> sinks_;
    FrameSource* others_;
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Waiting> waiting_;
    std::exception_ptr failure_;
    bool closed_ = false;
    std::thread thread_;  // last: it uses all of the others
};

}  // namespace campuswalk::engine::render
