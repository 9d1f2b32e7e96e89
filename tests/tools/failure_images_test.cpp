#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation/route_folder.h"
#include "engine/simulation/run_walk.h"
#include "tests/engine/render/small_scenes.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/map_image.h"

namespace campuswalk::tools {
namespace {

namespace fs = std::filesystem;
using namespace engine::render::test;
using engine::render::Image;

/// Grey ground with a red wall ahead of the origin; if `roofed`, under a green roof 3 m up.
scene::Campus small_campus(bool roofed) {
    SceneBuilder builder;
    builder.colored(kGrey).ground(60.0).colored(kRed).box({-3, 0, -6}, {3, 2, -5});
    scene::Campus campus = engine::level_campus(30.0);
    engine::add_box(campus, "wall", {-3, 0, -6}, {3, 2, -5});
    if (roofed) {
        builder.colored(kGreen).box({-8, 3, -8}, {8, 3.2, 8});
        engine::add_box(campus, "roof", {-8, 3, -8}, {8, 3.2, 8});
    }
    campus.models = {builder.model()};
    return campus;
}

engine::render::SnapshotSettings quick() {
    engine::render::SnapshotSettings settings;
    settings.light = quick_settings();
    return settings;
}

Image map_of(const scene::Campus& campus, const std::vector<Eigen::Vector3d>& path) {
    engine::render::SnapshotRenderer snapshot_renderer(campus, quick());
    return draw_map(campus, snapshot_renderer, {{}, {}, path, ""}, 320, 180);
}

template <typename Is>
int count(const Image& image, const Is& is) {
    int pixels = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto [r, g, b] = image.pixel(x, y);
            pixels += is(int{r}, int{g}, int{b}) ? 1 : 0;
        }
    }
    return pixels;
}

bool is_green(int r, int g, int b) {
    return g > 2 * r && g > 2 * b;
}

TEST(MapImage, HidesWhatIsAboveTheAvatar) {
    EXPECT_EQ(count(map_of(small_campus(true), {}), is_green), 0);
    // Beside the roof there is nothing to hide.
    const scene::Campus campus = small_campus(true);
    engine::render::SnapshotRenderer snapshot_renderer(campus, quick());
    MapState beside;
    beside.avatar.position = {12, 0, 0};
    EXPECT_GT(count(draw_map(campus, snapshot_renderer, beside, 320, 180), is_green), 2000);
}

TEST(MapImage, ShowsThePathWalkedAndTheAvatarAtItsEnd) {
    const auto yellow = [](int r, int g, int b) { return r > b + 50 && g > b + 25; };
    const scene::Campus campus = small_campus(false);
    EXPECT_EQ(count(map_of(campus, {}), yellow), 0);
    EXPECT_GT(count(map_of(campus, {{-10, 0, 5}, {0, 0, 5}, {0, 0, 0}}), yellow), 60);
    const auto [r, g, b] = map_of(campus, {}).pixel(160, 88);  // the arrow, a little before its place
    EXPECT_TRUE(r > 2 * g && r > 2 * b) << int{r} << " " << int{g} << " " << int{b};
}

/// A walk into the wall, and its failures.
class DrawnFailures : public testing::Test {
protected:
    DrawnFailures() { failures_ = engine::run_walk(campus_, walk_, {}).failures; }

    std::vector<std::string> drawn(const fs::path& folder = "stroll") {
        std::vector<std::string> paths;
        for (const engine::Artifact& artifact :
             draw_failures(campus_, walk_, failures_, folder_.path() / "out", folder, *renderers_)) {
            EXPECT_TRUE(fs::is_regular_file(folder_.path() / "out" / artifact.path)) << artifact.path;
            EXPECT_EQ(artifact.media_type, "image/png");
            paths.push_back(artifact.name + ": " + artifact.path);
        }
        return paths;
    }
    void fail_at(engine::Tick tick) {
        engine::Failure failure;
        failure.code = "never";
        failure.scene.tick = tick;
        failures_.push_back(failure);
    }

    std::string bytes(const std::string& path) const {
        std::ifstream stream(folder_.path() / "out" / path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    support::TemporaryFolder folder_;
    scene::Campus campus_ = small_campus(false);
    // Must be destroyed before the campus.
    std::shared_ptr<engine::render::RendererStore> renderers_ =
        make_renderers(engine::render::RenderingBackend::automatic);
    engine::Walk walk_ = engine::walk_of({engine::spawn_at({0, 0, 0}), engine::walk_to(0, -10)});
    std::vector<engine::Failure> failures_;
};

TEST_F(DrawnFailures, AreThreePerTickWithFailures) {
    ASSERT_EQ(failures_.size(), 1U);
    failures_.clear();
    fail_at(30);
    fail_at(30);
    fail_at(60);
    EXPECT_THAT(drawn(), testing::ElementsAre("failure at 0.50 s from the eyes: stroll/failure-eyes.png",
                                              "failure at 0.50 s from beside: stroll/failure-beside.png",
                                              "failure at 0.50 s from above: stroll/failure-above.png",
                                              "failure at 1.00 s from the eyes: stroll/failure-2-eyes.png",
                                              "failure at 1.00 s from beside: stroll/failure-2-beside.png",
                                              "failure at 1.00 s from above: stroll/failure-2-above.png"));
}

/// A place that can't be reached takes long to be found so: the walk that is played again must not ask anew.
TEST_F(DrawnFailures, TakeRoutesFromTheMemoryOfThePlayedWalk) {
    engine::GoToStep go_to;
    go_to.target = {"in the wall", {0, 0, -5.5}, true};
    walk_ = engine::walk_of({engine::spawn_at({0, 0, 0}), go_to});
    const scene::CacheFolder routes(folder_.path() / "routes");
    engine::RouteMemory memory;
    memory.store =
        std::make_shared<engine::RouteFolder>(routes, scene::hash_of(std::as_bytes(std::span("campus"))));
    failures_ = engine::run_walk(campus_, walk_, {}, &memory).failures;
    ASSERT_EQ(failures_.size(), 1U);
    EXPECT_EQ(failures_[0].code, "unreachable");
    const auto stored = [&] {
        return std::ranges::count_if(
            fs::directory_iterator(folder_.path() / "routes"),
            [](const std::string& name) { return name.ends_with(".route.campuswalk"); },
            [](const fs::directory_entry& entry) { return entry.path().filename().string(); });
    };
    ASSERT_EQ(stored(), 1) << "the reason";
    // Whoever plans it anew stores it anew.
    fs::remove_all(folder_.path() / "routes");
    draw_failures(campus_, walk_, failures_, folder_.path() / "out", "stroll", *renderers_, &memory);
    EXPECT_FALSE(fs::exists(folder_.path() / "routes"));
}

TEST_F(DrawnFailures, DoNotDependOnFailuresOfOtherWalks) {
    failures_.clear();
    fail_at(60);
    drawn("first");
    const scene::Campus other = small_campus(true);
    draw_failures(other, walk_, failures_, folder_.path() / "out", "other", *renderers_);
    failures_[0].scene.tick = 10;
    drawn("between");
    failures_[0].scene.tick = 60;
    drawn("again");
    for (const std::string name : {"/failure-eyes.png", "/failure-beside.png", "/failure-above.png"}) {
        EXPECT_FALSE(bytes("first" + name).empty());
        EXPECT_EQ(bytes("again" + name), bytes("first" + name)) << name;
        EXPECT_NE(bytes("between" + name), bytes("first" + name)) << name;
        EXPECT_NE(bytes("other" + name), bytes("first" + name)) << name;
    }
}

TEST_F(DrawnFailures, AreNoneWithoutAFailure) {
    failures_.clear();
    EXPECT_TRUE(drawn().empty());
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(DrawnFailures, AfterTheLastTickShowTheLastTick) {
    failures_.clear();
    fail_at(1000000);
    const std::vector<std::string> last = drawn();
    ASSERT_EQ(last.size(), 3U);
    EXPECT_THAT(last[0], testing::EndsWith("stroll/failure-eyes.png"));
}

TEST_F(DrawnFailures, ThrowIfTheyCannotBeWritten) {
    folder_.write("out/stroll", "in the way");
    EXPECT_THROW(drawn(), std::runtime_error);
}

}  // namespace
}  // namespace campuswalk::tools
