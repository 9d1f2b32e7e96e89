#include "engine/render/snapshot/snapshot_renderer.h"

#include <utility>

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

SnapshotRequest request(View view, int width = kWidth, int height = kHeight) {
    SnapshotRequest request;
    request.camera.view = std::move(view);
    request.camera.width = width;
    request.camera.height = height;
    request.avatar.position = {1, 0, 2};
    request.minimap = false;
    return request;
}

TEST(SnapshotRenderer, DrawsTheThreeViews) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    const Image first = snapshot_renderer.draw(request(FirstPersonView{}));
    const Image third = snapshot_renderer.draw(request(ThirdPersonView{}));
    const Image top = snapshot_renderer.draw(request(TopView{}));
    EXPECT_GT(differing_pixels(first, third), first.rgba.size() / 4 / 10);
    EXPECT_GT(differing_pixels(first, top), first.rgba.size() / 4 / 2);
    EXPECT_EQ(snapshot_renderer.draw(request(FirstPersonView{})).rgba, first.rgba);
}

TEST(SnapshotRenderer, ThirdPersonShowsTheAvatarUnlessTheCameraIsInItsHead) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer roomy(campus, settings());
    SnapshotSettings tight = settings();
    tight.free_distance = [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return 0.0; };
    SnapshotRenderer cramped(campus, tight);
    const auto orange = [](const Image& image) {  // of the walker's jacket
        int count = 0;
        for (int y = image.height / 3; y < image.height; ++y) {
            for (int x = 70; x < 90; ++x) {
                const auto [r, g, b] = image.pixel(x, y);
                count += r > 1.7 * g && r > 1.9 * b && r > 90 ? 1 : 0;
            }
        }
        return count;
    };
    SnapshotRequest away = request(ThirdPersonView{});
    away.avatar.yaw = 3.141592653589793;  // the tower is behind the camera
    EXPECT_GT(orange(roomy.draw(away)), 20);
    EXPECT_EQ(orange(cramped.draw(away)), 0);
}

TEST(SnapshotRenderer, DrawsOpenPopupsOverTheImage) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    SnapshotRequest open = request(FirstPersonView{}, 640, 360);
    const Image closed_image = snapshot_renderer.draw(open);
    const std::vector<OpenPopup> popups = {{0, "Tower", "As it opened."}};
    open.open_popups = popups;
    const Image open_image = snapshot_renderer.draw(open);
    EXPECT_GT(differing_pixels(closed_image, open_image), 5000U);
    const auto same_at = [&](int x, int y) { return open_image.pixel(x, y) == closed_image.pixel(x, y); };
    EXPECT_TRUE(same_at(10, 10));
    EXPECT_TRUE(same_at(600, 340));
}

TEST(SnapshotRenderer, OrbitFillsTheImageWithTheBuilding) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    SnapshotRequest around = request(OrbitView{.around = CameraTarget{"tower", 0, {}}});
    around.nobody = true;
    const IdImage ids = snapshot_renderer.draw_ids(around);
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

TEST(SnapshotRenderer, OrbitWithoutATargetCirclesTheAvatar) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    SnapshotRequest around = request(OrbitView{.distance = 4.0});
    SnapshotRequest empty = around;
    empty.nobody = true;
    const Channels with = snapshot_renderer.draw_channels(around, {.depth = true});
    const Channels without = snapshot_renderer.draw_channels(empty, {.depth = true});
    const std::size_t middle = kHeight / 2 * kWidth + kWidth / 2;
    EXPECT_NEAR(with.depth[middle], 4.0, 0.3);
    EXPECT_GT(without.depth[middle], 4.5);
}

TEST(SnapshotRenderer, FixedUsesItsPositionAndTarget) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    const Eigen::Vector3d position(8, 3, 2);
    SnapshotRequest fixed = request(FixedView{.position = position, .look_at = CameraTarget{"tower", 0, {}}});
    fixed.nobody = true;
    const std::size_t middle = kHeight / 2 * kWidth + kWidth / 2;
    EXPECT_EQ(snapshot_renderer.draw_ids(fixed).ids[middle], 1U);
    fixed.camera.view = FixedView{.position = position, .yaw = 3.141592653589793};
    EXPECT_EQ(snapshot_renderer.draw_ids(fixed).ids[middle], 0U) << "turned away";
}

TEST(SnapshotRenderer, IdsIdentifyThePixelOwners) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    SnapshotRequest camera = request(FirstPersonView{});
    const std::vector<OpenPopup> popups = {{0, "Tower", "It hides nothing here."}};
    camera.open_popups = popups;
    const IdImage image = snapshot_renderer.draw_ids(camera);
    ASSERT_EQ(image.owners.size(), 2U);
    EXPECT_EQ(image.owners[1].building, 0U);
    const auto id_at = [&](double x, double y, double z) {
        const Viewpoint view = first_person(camera.avatar, camera.profile, camera.camera.fov);
        const auto pixel = pixel_of(view, kWidth, kHeight, {x, y, z});
        return image
            .ids[static_cast<std::size_t>(pixel->y()) * kWidth + static_cast<std::size_t>(pixel->x())];
    };
    EXPECT_EQ(id_at(0, 3, -8), 1U) << "the tower";
    EXPECT_EQ(id_at(-4, 0, -4), 0U) << "the ground";
    EXPECT_EQ(id_at(6, 6, -8), 0U) << "the sky";
}

TEST(SnapshotRenderer, TheAvatarOccludesOwnersInIds) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    SnapshotRequest behind = request(ThirdPersonView{2.0});
    behind.avatar.position = {0, 0, -4};
    // From the same place without the figure.
    const Viewpoint view = third_person(behind.avatar, behind.profile, behind.camera.fov, 2.0, {});
    Renderer renderer(campus.models, quick_settings());
    const Channels bare = renderer.draw_channels(view, kWidth, kHeight, {.nodes = true});
    const IdImage ids = snapshot_renderer.draw_ids(behind);
    EXPECT_LT(std::ranges::count(ids.ids, 1U), std::ranges::count(bare.nodes, 2U) - 100);
}

TEST(SnapshotRenderer, AddsAMinimapToAvatarViewsOnly) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    for (const View& view : {View(FirstPersonView{}), View(TopView{})}) {
        SnapshotRequest camera = request(view, 480, 270);
        const Image b = snapshot_renderer.draw(camera);
        camera.minimap = true;
        const Image a = snapshot_renderer.draw(camera);
        EXPECT_EQ(differing_pixels(a, b) > 1000U, std::holds_alternative<FirstPersonView>(view));
        EXPECT_EQ(a.pixel(400, 100), b.pixel(400, 100));
    }
}

TEST(SnapshotRenderer, LabelsBuildingsInAnyView) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    for (const View& view : {View(FirstPersonView{}), View(TopView{}), View(OrbitView{})}) {
        SnapshotRequest camera = request(view, 480, 270);
        const Image nameless = snapshot_renderer.draw(camera);
        camera.overlays.labels = true;
        EXPECT_GT(differing_pixels(snapshot_renderer.draw(camera), nameless), 50U) << view.index();
    }
}

TEST(SnapshotRenderer, PlanShowsTheWholeCampusWithLabels) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    SnapshotSettings bare = settings();
    bare.labels = false;
    SnapshotRenderer nameless(campus, bare);
    const Image plan = snapshot_renderer.draw_plan(320, 180, true);
    EXPECT_EQ(plan.width, 320);
    EXPECT_EQ(plan.height, 180);
    EXPECT_GT(differing_pixels(plan, nameless.draw_plan(320, 180, true)), 50U);
}

TEST(SnapshotRenderer, GridsAreDrawnOverPlansAndTopViewsOnRequest) {
    const scene::Campus campus = tower_campus();
    SnapshotRenderer snapshot_renderer(campus, settings());
    EXPECT_GT(differing_pixels(snapshot_renderer.draw_plan(320, 180, true),
                               snapshot_renderer.draw_plan(320, 180, false)),
              1000U);
    for (const View& view : {View(FirstPersonView{}), View(TopView{})}) {
        SnapshotRequest camera = request(view, 320, 180);
        const Image bare = snapshot_renderer.draw(camera);
        camera.overlays.grid = true;
        EXPECT_EQ(differing_pixels(snapshot_renderer.draw(camera), bare) > 1000U,
                  std::holds_alternative<TopView>(view));
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test
