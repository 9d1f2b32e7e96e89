#include "engine/render/sequence/sequence_observer.h"

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

class Times final : public FrameSink {
public:
    explicit Times(std::vector<Frame>& frames) : frames_(frames) {}
    void add(const Frame& frame) override { frames_.push_back(frame); }
    void finish() override {}

private:
    std::vector<Frame>& frames_;
};

/// The frames of a walk of so many ticks.
std::vector<Frame> frames_of(double every, int ticks, int ticks_per_second) {
    const scene::Campus campus = campus_of(tower_scene());
    SequenceSettings settings;
    settings.every = every;
    settings.camera.width = 32;
    settings.camera.height = 18;
    settings.drawing.light = quick_settings();
    settings.drawing.minimap = false;
    std::vector<Frame> frames;
    std::vector<std::unique_ptr<FrameSink>> sinks;
    sinks.push_back(std::make_unique<Times>(frames));
    SequenceObserver observer(campus, settings, std::move(sinks));
    observer.begin({});
    FrameRecord record;
    for (int i = 0; i < ticks; ++i) {
        record.tick = static_cast<Tick>(i);
        record.time = static_cast<double>(i) / ticks_per_second;
        record.avatar.position = {1.0, 0.0, 2.0 - 0.02 * i};
        observer.frame(record);
    }
    observer.frame(record);  // the closing one
    observer.end();
    return frames;
}

TEST(SequenceObserver, TakesFramesAtEvenTimes) {
    const std::vector<Frame> frames = frames_of(0.1, 61, 60);
    ASSERT_EQ(frames.size(), 11U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].number, i);
        EXPECT_NEAR(frames[i].time, 0.1 * static_cast<double>(i), 1e-12);
        EXPECT_EQ(frames[i].picture.width, 32);
    }
    EXPECT_NE(frames.front().picture.rgba, frames.back().picture.rgba);
}

TEST(SequenceObserver, TakesThemAtTheTickAfterWhereNoneFalls) {
    const std::vector<Frame> frames = frames_of(0.25, 31, 10);
    ASSERT_EQ(frames.size(), 13U);
    EXPECT_NEAR(frames[1].time, 0.3, 1e-12);
    EXPECT_NEAR(frames[2].time, 0.5, 1e-12);
    EXPECT_NEAR(frames[3].time, 0.8, 1e-12);
    EXPECT_NEAR(frames[12].time, 3.0, 1e-12);
}

TEST(SequenceObserver, TakesOneATickAtMost) {
    EXPECT_EQ(frames_of(0.001, 7, 60).size(), 7U);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
