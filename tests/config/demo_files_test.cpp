// The configuration files in the repository load.

#include <algorithm>

#include <gtest/gtest.h>

#include "config/loader/load_campus.h"
#include "config/loader/load_profile.h"
#include "config/loader/load_run.h"

namespace campuswalk::config {
namespace {

namespace fs = std::filesystem;

const fs::path kConfig = fs::path(CAMPUSWALK_SOURCE_FOLDER) / "config";

std::vector<fs::path> files_in(const fs::path& folder, const std::string& suffix) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().string().ends_with(suffix)) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

TEST(DemoFiles, CampusLoads) {
    const scene::CampusDescription campus = load_campus_description(kConfig / "demo.campus.yaml");
    EXPECT_EQ(campus.name, "demo");
    EXPECT_GE(campus.buildings.size(), 12U);
    for (const scene::SceneFile& scene : campus.scenes) {
        EXPECT_TRUE(fs::is_regular_file(scene.path)) << scene.path;
    }
}

TEST(DemoFiles, WalksLoad) {
    const std::vector<fs::path> walks = files_in(kConfig / "walks", ".walk.yaml");
    EXPECT_FALSE(walks.empty());
    for (const fs::path& file : walks) {
        const config::Run run = load_run(file, {});
        EXPECT_GT(run.walk.steps.size(), 1U) << file;
        EXPECT_FALSE(run.walk.expectations.empty()) << file;
    }
}

TEST(DemoFiles, AvatarsLoad) {
    const std::vector<fs::path> avatars = files_in(kConfig / "avatars", ".avatar.yaml");
    EXPECT_GE(avatars.size(), 3U);
    for (const fs::path& file : avatars) {
        const engine::AvatarProfile avatar = load_avatar(file);
        EXPECT_GE(avatar.height, 2 * avatar.radius) << file;
    }
}

TEST(DemoFiles, LightsLoad) {
    std::vector<std::string> names;
    for (const fs::path& file : files_in(kConfig / "lights", ".light.yaml")) {
        EXPECT_TRUE(load_light(file).sun_color) << file;
        names.push_back(file.filename().string());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"day.light.yaml", "night.light.yaml", "overcast.light.yaml"}));
}

}  // namespace
}  // namespace campuswalk::config
