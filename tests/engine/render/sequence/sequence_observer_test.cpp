#include "engine/render/sequence/sequence_observer.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

class CollectingSink final : public FrameSink {
public:
    explicit CollectingSink(std::vector<Frame>& frames) : frames_(frames) {}
    void add(const Frame& frame) override { frames_.push_back(frame); }
    void finish() override {}

private:
    std::vector<Frame>& frames_;
};

/// Supplies frames that were drawn before.
class StoredFrames final : public FrameSource {
public:
    explicit StoredFrames(std::vector<Frame> frames) : frames_(std::move(frames)) {}
    Frame take(std::size_t number) override {
        const auto found = std::ranges::find(frames_, number, &Frame::number);
        return found == frames_.end() ? throw std::runtime_error("no such frame") : *found;
    }

private:
    std::vector<Frame> frames_;
};

/// The frames of a walk that takes this many ticks.
std::vector<Frame> frames_of(double every, int ticks, int ticks_per_second, const Walk& walk = {},
                             const SequenceShare& share = {}, std::unique_ptr<FrameSource> others = nullptr) {
    const scene::Campus campus = campus_of(tower_scene());
    SequenceSettings settings;
    settings.every = every;
    settings.camera.width = 32;
    settings.camera.height = 18;
    RendererStore renderers([](const scene::Campus&) {
        SnapshotSettings drawing;
        drawing.light = quick_settings();
        return drawing;
    });
    std::vector<Frame> frames;
    std::vector<std::unique_ptr<FrameSink>> sinks;
    sinks.push_back(std::make_unique<CollectingSink>(frames));
    settings.share = share;
    SequenceObserver observer(campus, settings, renderers, std::move(sinks), std::move(others));
    observer.begin(walk);
    TickRecord record;
    for (int i = 0; i < ticks; ++i) {
        record.tick = static_cast<Tick>(i);
        record.time = static_cast<double>(i) / ticks_per_second;
        record.avatar.position = {1.0, 0.0, 2.0 - 0.02 * i};
        observer.on_tick(record);
    }
    observer.on_tick(record);  // the closing record
    observer.end();
    return frames;
}

TEST(SequenceObserver, DrawsFramesAtRegularTimes) {
    const std::vector<Frame> frames = frames_of(0.1, 61, 60);
    ASSERT_EQ(frames.size(), 11U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].number, i);
        EXPECT_NEAR(frames[i].time, 0.1 * static_cast<double>(i), 1e-12);
        EXPECT_EQ(frames[i].image.width, 32);
    }
    EXPECT_NE(frames.front().image.rgba, frames.back().image.rgba);
}

TEST(SequenceObserver, DrawsAtTheFirstTickAtOrAfterTheTime) {
    const std::vector<Frame> frames = frames_of(0.25, 31, 10);
    ASSERT_EQ(frames.size(), 13U);
    EXPECT_NEAR(frames[1].time, 0.3, 1e-12);
    EXPECT_NEAR(frames[2].time, 0.5, 1e-12);
    EXPECT_NEAR(frames[3].time, 0.8, 1e-12);
    EXPECT_NEAR(frames[12].time, 3.0, 1e-12);
}

TEST(SequenceObserver, UsesTheWalksLight) {
    Walk dark;
    dark.light.sun_color = dark.light.sky_light = dark.light.ground_light = Eigen::Vector3d::Zero();
    dark.light.zenith_color = dark.light.horizon_color = Eigen::Vector3d::Zero();
    const auto brightness_of = [](const std::vector<Frame>& frames) {
        const Image& image = frames.at(0).image;
        return std::accumulate(image.rgba.begin(), image.rgba.end(), 0.0);
    };
    EXPECT_LT(brightness_of(frames_of(1.0, 2, 60, dark)), 0.7 * brightness_of(frames_of(1.0, 2, 60)));
}

TEST(SequenceObserver, DividesFramesBetweenProcesses) {
    const std::vector<Frame> whole = frames_of(0.1, 61, 60);
    std::vector<Frame> by_others = frames_of(0.1, 61, 60, {}, {1, 3});
    ASSERT_EQ(by_others.size(), 4U);
    EXPECT_EQ(by_others[2].number, 7U);
    std::ranges::copy(frames_of(0.1, 61, 60, {}, {2, 3}), std::back_inserter(by_others));
    const std::vector<Frame> shared =
        frames_of(0.1, 61, 60, {}, {0, 3}, std::make_unique<StoredFrames>(std::move(by_others)));
    ASSERT_EQ(shared.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(shared[i].number, i);
        EXPECT_EQ(shared[i].time, whole[i].time);
        EXPECT_EQ(shared[i].image.rgba, whole[i].image.rgba) << i;
    }
}

TEST(SequenceObserver, DrawsAtMostOneFramePerTick) {
    EXPECT_EQ(frames_of(0.001, 7, 60).size(), 7U);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
