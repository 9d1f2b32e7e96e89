#include "engine/render/sequence/frame_queue.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::engine::render::test {
namespace {

/// Thread-safe record of delivered frames.
struct Seen {
    std::vector<std::size_t> numbers;
    std::vector<std::thread::id> threads;
    std::atomic<int> pending = 0;
    bool finished = false;
};

class RecordingSink final : public FrameSink {
public:
    explicit RecordingSink(Seen& seen, std::size_t bad = 1'000'000) : seen_(seen), bad_(bad) {}
    void add(const Frame& frame) override {
        if (frame.number == bad_) {
            throw std::runtime_error("the disk is full");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        seen_.numbers.push_back(frame.number);
        seen_.threads.push_back(std::this_thread::get_id());
        --seen_.pending;
    }
    void finish() override { seen_.finished = true; }

private:
    Seen& seen_;
    std::size_t bad_;
};

std::vector<std::unique_ptr<FrameSink>> sinks(std::unique_ptr<FrameSink> one) {
    std::vector<std::unique_ptr<FrameSink>> all;
    all.push_back(std::move(one));
    return all;
}

TEST(FrameQueue, DeliversFramesInOrderOnItsOwnThread) {
    Seen seen;
    FrameQueue queue(sinks(std::make_unique<RecordingSink>(seen)));
    int max_pending = 0;
    for (std::size_t i = 0; i < 100; ++i) {
        queue.add({{}, i, 0.0});
        max_pending = std::max(max_pending, ++seen.pending);
    }
    queue.finish();
    ASSERT_EQ(seen.numbers.size(), 100U);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(seen.numbers[i], i);
        EXPECT_NE(seen.threads[i], std::this_thread::get_id());
    }
    EXPECT_TRUE(seen.finished);
    EXPECT_LE(max_pending, 7) << "add blocks while the queue is full";
}

TEST(FrameQueue, RethrowsSinkErrors) {
    Seen seen;
    FrameQueue queue(sinks(std::make_unique<RecordingSink>(seen, 3)));
    EXPECT_THROW(
        {
            for (std::size_t i = 0; i < 100; ++i) {
                queue.add({{}, i, 0.0});
            }
        },
        std::runtime_error);
    EXPECT_EQ(seen.numbers.size(), 3U);
    EXPECT_THROW(queue.finish(), std::runtime_error);
    EXPECT_FALSE(seen.finished);
}

/// Supplies the frames of other processes; from number `bad` on it fails.
class RemoteFrames final : public FrameSource {
public:
    explicit RemoteFrames(std::size_t bad = 1'000'000) : bad_(bad) {}
    Frame take(std::size_t number) override {
        if (number >= bad_) {
            throw std::runtime_error("the other process is gone");
        }
        return {{}, number, 1.0};
    }

private:
    std::size_t bad_;
};

TEST(FrameQueue, InterleavesRemoteFrames) {
    Seen seen;
    RemoteFrames others;
    FrameQueue queue(sinks(std::make_unique<RecordingSink>(seen)), &others, 3);
    for (std::size_t i = 0; i < 50; ++i) {
        ++seen.pending;
        i % 3 == 0 ? queue.add({{}, i, 0.0}) : queue.add_remote(i);
    }
    queue.finish();
    ASSERT_EQ(seen.numbers.size(), 50U);
    for (std::size_t i = 0; i < 50; ++i) {
        EXPECT_EQ(seen.numbers[i], i);
    }
}

TEST(FrameQueue, RethrowsErrorsOfTheRemoteSource) {
    Seen seen;
    RemoteFrames others(5);
    FrameQueue queue(sinks(std::make_unique<RecordingSink>(seen)), &others, 2);
    EXPECT_THROW(
        {
            for (std::size_t i = 0; i < 100; ++i) {
                i % 2 == 0 ? queue.add({{}, i, 0.0}) : queue.add_remote(i);
            }
        },
        std::runtime_error);
    EXPECT_EQ(seen.numbers.size(), 5U);
    EXPECT_THROW(queue.finish(), std::runtime_error);
    EXPECT_FALSE(seen.finished);
}

TEST(FrameQueue, DiscardsPendingFramesWithoutFinish) {
    Seen seen;
    {
        FrameQueue queue(sinks(std::make_unique<RecordingSink>(seen)));
        queue.add({{}, 0, 0.0});
    }
    EXPECT_FALSE(seen.finished);
    FrameQueue nothing({});
    nothing.finish();
}

}  // namespace
}  // namespace campuswalk::engine::render::test
