#include "engine/render/snapshot/snapshot_observer.h"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/engine/render/scratch_folder.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

class SnapshotObserverTest : public testing::Test {
protected:
    SnapshotObserverTest() {
        walk_.name = "stroll";
        gate_.name = "gate";
        gate_.camera.width = kWidth;
        gate_.camera.height = kHeight;
    }

    // A walk of `ticks` with an image at the last one.
    void walk(SnapshotObserver& observer, int ticks, bool image = true) const {
        observer.begin(walk_);
        const std::vector<const SnapshotStep*> steps = {&gate_};
        TickRecord record;
        for (int i = 0; i < ticks; ++i) {
            record.tick = static_cast<Tick>(i);
            record.avatar.position = {1.0, 0.0, 2.0 - 0.02 * i};
            if (image && i + 1 == ticks) {
                record.snapshots = steps;
            }
            observer.on_tick(record);
        }
        observer.end();
    }

    static std::string bytes(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    scene::Campus campus_ = campus_of(tower_scene());
    RendererStore renderers_{[](const scene::Campus&) {
        SnapshotSettings settings;
        settings.light = quick_settings();
        return settings;
    }};
    Walk walk_;
    SnapshotStep gate_;
    ScratchFolder folder_;
};

TEST_F(SnapshotObserverTest, WritesAnImageNamedAfterItsStep) {
    SnapshotObserver observer(campus_, folder_.path() / "out", renderers_);
    walk(observer, 5);
    const std::filesystem::path file = folder_.path() / "out" / "gate.png";
    EXPECT_EQ(observer.files(), std::vector<std::filesystem::path>{file});
    EXPECT_EQ(bytes(file).substr(1, 3), "PNG");
}

TEST_F(SnapshotObserverTest, WritesTheSameFileForTheSameWalk) {
    std::vector<std::string> files;
    for (const char* out : {"a", "b"}) {
        SnapshotObserver observer(campus_, folder_.path() / out, renderers_);
        walk(observer, 20);
        files.push_back(bytes(observer.files().at(0)));
    }
    EXPECT_EQ(files[0], files[1]);
    EXPECT_GT(files[0].size(), 1000U);
}

TEST_F(SnapshotObserverTest, UsesEachWalksLight) {
    SnapshotObserver observer(campus_, folder_.path(), renderers_);
    walk(observer, 5);
    const std::string day = bytes(observer.files().at(0));
    walk_.light.shadows = false;
    walk(observer, 5);
    EXPECT_NE(bytes(observer.files().at(1)), day);
    walk_.light = {};
    walk(observer, 5);
    EXPECT_EQ(bytes(observer.files().at(2)), day);
}

TEST_F(SnapshotObserverTest, CreatesNoFolderWithoutSnapshots) {
    SnapshotObserver observer(campus_, folder_.path() / "out", renderers_);
    walk(observer, 5, false);
    EXPECT_TRUE(observer.files().empty());
    EXPECT_TRUE(folder_.contents().empty());
}

TEST_F(SnapshotObserverTest, ReportsAnUnwritableFolderAndLeavesNoFile) {
    std::ofstream(folder_.path() / "out") << "in the way";
    SnapshotObserver observer(campus_, folder_.path() / "out", renderers_);
    try {
        walk(observer, 5);
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("gate.png"), std::string::npos) << message;
    }
    EXPECT_TRUE(observer.files().empty());
    EXPECT_EQ(folder_.contents(), std::vector<std::filesystem::path>{"out"});
}

}  // namespace
}  // namespace campuswalk::engine::render::test
