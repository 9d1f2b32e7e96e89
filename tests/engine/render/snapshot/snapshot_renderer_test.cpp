#include "engine/render/snapshot/snapshot_renderer.h"

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

scene::Campus tower_campus() {
    scene::Building tower;
    tower.id = "tower";
    tower.title = "Tower";
    tower.text = "Seven metres of colour.";
    return campus_of(tower_scene(), {tower});
}

SnapshotSettings settings() {
    SnapshotSettings settings;
    settings.light = quick_settings();
    return settings;
}

Shot shot(View view, int width = kWidth, int height = kHeight) {
    Shot shot;
    shot.camera.view = view;
    shot.camera.width = width;
    shot.camera.height = height;
    shot.avatar.position = {1, 0, 2};
    shot.minimap = false;
    return shot;
}

TEST(SnapshotPainter, DrawsTheThreeViews) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    const Picture first = painter.draw(shot(View::first_person));
    const Picture third = painter.draw(shot(View::third_person));
    const Picture top = painter.draw(shot(View::top));
    EXPECT_GT(differing_pixels(first, third), first.rgba.size() / 4 / 10);
    EXPECT_GT(differing_pixels(first, top), first.rgba.size() / 4 / 2);
    EXPECT_EQ(painter.draw(shot(View::first_person)).rgba, first.rgba);
}

TEST(SnapshotPainter, ThirdPersonSeesTheAvatarUnlessTheCameraIsInItsHead) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter roomy(campus, settings());
    SnapshotSettings tight = settings();
    tight.free_distance = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return 0.0; };
    SnapshotPainter cramped(campus, tight);
    const auto orange = [](const Picture& picture) {  // of the walker's jacket
        int count = 0;
        for (int y = picture.height / 3; y < picture.height; ++y) {
            for (int x = 70; x < 90; ++x) {
                const auto [r, g, b] = picture.pixel(x, y);
                count += r > 1.7 * g && r > 1.9 * b && r > 90 ? 1 : 0;
            }
        }
        return count;
    };
    Shot away = shot(View::third_person);
    away.avatar.yaw = 3.141592653589793;  // the tower is behind the camera
    EXPECT_GT(orange(roomy.draw(away)), 20);
    EXPECT_EQ(orange(cramped.draw(away)), 0);
}

TEST(SnapshotPainter, DrawsTheOpenPopupOverThePicture) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    Shot open = shot(View::first_person, 640, 360);
    const Picture closed_picture = painter.draw(open);
    const std::vector<OpenPopup> popups = {{0, "Tower", "As it opened."}};
    open.open_popups = popups;
    const Picture open_picture = painter.draw(open);
    EXPECT_GT(differing_pixels(closed_picture, open_picture), 5000U);
    const auto at = [&](int x, int y) { return open_picture.pixel(x, y) == closed_picture.pixel(x, y); };
    EXPECT_TRUE(at(10, 10));
    EXPECT_TRUE(at(600, 340));
}

TEST(SnapshotPainter, OrbitFillsThePictureWithTheBuilding) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    Shot around = shot(View::orbit);
    around.nobody = true;
    around.camera.around = CameraTarget{"tower", 0, {}};
    const IdPicture ids = painter.draw_ids(around);
    int top = kHeight;
    int bottom = 0;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        if (ids.ids[static_cast<std::size_t>(i)] == 1) {
            top = std::min(top, i / kWidth);
            bottom = i / kWidth;
        }
    }
    EXPECT_GT(top, 0);
    EXPECT_LT(bottom, kHeight - 1);
    EXPECT_GT(bottom - top, 3 * kHeight / 4);
}

TEST(SnapshotPainter, OrbitWithoutATargetGoesAroundTheAvatar) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    Shot around = shot(View::orbit);
    around.camera.distance = 4.0;
    Shot empty = around;
    empty.nobody = true;
    const Channels with = painter.draw_channels(around, {.depth = true});
    const Channels without = painter.draw_channels(empty, {.depth = true});
    const std::size_t middle = kHeight / 2 * kWidth + kWidth / 2;
    EXPECT_NEAR(with.depth[middle], 4.0, 0.3);
    EXPECT_GT(without.depth[middle], 4.5);
}

TEST(SnapshotPainter, FixedStandsWhereItIsPutAndLooksWhereItIsTold) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    Shot fixed = shot(View::fixed);
    fixed.nobody = true;
    fixed.camera.position = Eigen::Vector3d(8, 3, 2);
    fixed.camera.look_at = CameraTarget{"tower", 0, {}};
    const std::size_t middle = kHeight / 2 * kWidth + kWidth / 2;
    EXPECT_EQ(painter.draw_ids(fixed).ids[middle], 1U);
    fixed.camera.look_at.reset();
    fixed.camera.yaw = 3.141592653589793;
    EXPECT_EQ(painter.draw_ids(fixed).ids[middle], 0U) << "turned away";
}

TEST(SnapshotPainter, IdsTellWhoseThePixelsAre) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    Shot camera = shot(View::first_person);
    const std::vector<OpenPopup> popups = {{0, "Tower", "It hides nothing here."}};
    camera.open_popups = popups;
    const IdPicture picture = painter.draw_ids(camera);
    ASSERT_EQ(picture.names.size(), 2U);
    EXPECT_EQ(picture.names[1].building, 0U);
    const auto id_at = [&](double x, double y, double z) {
        const Viewpoint view = first_person(camera.avatar, camera.profile, camera.camera.fov);
        const auto pixel = pixel_of(view, kWidth, kHeight, {x, y, z});
        return picture
            .ids[static_cast<std::size_t>(pixel->y()) * kWidth + static_cast<std::size_t>(pixel->x())];
    };
    EXPECT_EQ(id_at(0, 3, -8), 1U) << "the tower";
    EXPECT_EQ(id_at(-4, 0, -4), 0U) << "the ground";
    EXPECT_EQ(id_at(6, 6, -8), 0U) << "the sky";
}

TEST(SnapshotPainter, TheAvatarHidesWhatIsBehindItInIdsToo) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    Shot behind = shot(View::third_person);
    behind.avatar.position = {0, 0, -4};
    behind.camera.distance = 2.0;
    // From the same place without the figure.
    const Viewpoint view = third_person(behind.avatar, behind.profile, behind.camera.fov, 2.0, {});
    Renderer renderer(campus.models, quick_settings());
    const Channels bare = renderer.draw_channels(view, kWidth, kHeight, {.nodes = true});
    const IdPicture ids = painter.draw_ids(behind);
    EXPECT_LT(std::ranges::count(ids.ids, 1U), std::ranges::count(bare.nodes, 2U) - 100);
}

TEST(SnapshotPainter, AddsAMinimapToViewsFromTheAvatarOnly) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    for (const View view : {View::first_person, View::top}) {
        Shot camera = shot(view, 480, 270);
        const Picture b = painter.draw(camera);
        camera.minimap = true;
        const Picture a = painter.draw(camera);
        EXPECT_EQ(differing_pixels(a, b) > 1000U, view == View::first_person);
        EXPECT_EQ(a.pixel(400, 100), b.pixel(400, 100));
    }
}

TEST(SnapshotPainter, PlanShowsTheWholeCampusWithNames) {
    const scene::Campus campus = tower_campus();
    SnapshotPainter painter(campus, settings());
    SnapshotSettings bare = settings();
    bare.labels = false;
    SnapshotPainter nameless(campus, bare);
    const Picture plan = painter.draw_plan(320, 180);
    EXPECT_EQ(plan.width, 320);
    EXPECT_EQ(plan.height, 180);
    EXPECT_GT(differing_pixels(plan, nameless.draw_plan(320, 180)), 50U);
}

}  // namespace
}  // namespace campuswalk::engine::render::test
