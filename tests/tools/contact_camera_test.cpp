#include "tools/campuswalk/images/contact_camera.h"

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"
#include "tests/engine/small_campus.h"

// Whether a failure's picture shows what is in the way.

namespace campuswalk::tools {
namespace {

using namespace engine::render::test;
using engine::render::Image;
using engine::render::SnapshotRenderer;
using engine::render::SnapshotRequest;

/// Grey ground with a red wall just ahead of an avatar at the origin, and more to be built.
struct Yard {
    SceneBuilder builder;
    scene::Campus campus = engine::level_campus(30.0);

    Yard() {
        builder.colored(kGrey).ground(60.0);
        add_solid(kRed, "wall", {-3, 0, -1.4}, {3, 3, -0.32});
    }
    void add_solid(const Color& color, const std::string& id, const Eigen::Vector3d& min,
                   const Eigen::Vector3d& max) {
        builder.colored(color).box(min, max);
        engine::add_box(campus, id, min, max);
    }

    /// The image, and where the contact is in it, at breast height.
    struct Drawn {
        Image image;
        Eigen::Vector2d contact;

        bool shows_wall() const {
            const auto [r, g, b] = image.pixel(static_cast<int>(contact.x()), static_cast<int>(contact.y()));
            return r > 2 * g && r > 2 * b;
        }
    };
    Drawn drawn(bool nobody = false) {
        campus.models = {builder.model()};
        engine::render::SnapshotSettings settings;
        settings.light = quick_settings();
        SnapshotRenderer snapshot_renderer(campus, settings);
        SnapshotRequest request;
        request.camera.width = kWidth;
        request.camera.height = kHeight;
        request.minimap = false;
        const Eigen::Vector3d contact(0, 1.2, -0.32);
        const auto view = aim_at_contact(campus, snapshot_renderer, contact, request);
        request.nobody = nobody;
        const auto pixel = engine::render::pixel_of(view, kWidth, kHeight, contact);
        return {snapshot_renderer.draw(request), pixel.value()};
    }
};

int differing_pixels(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        }
    }
    return count;
}

TEST(ContactCamera, ShowsTheObstacleBesideTheAvatar) {
    Yard yard;
    const Yard::Drawn drawn = yard.drawn();
    EXPECT_TRUE(drawn.shows_wall());
    EXPECT_GT(differing_pixels(drawn.image, yard.drawn(true).image), 300) << "the avatar";
}

TEST(ContactCamera, LooksFromWhereNothingThatIsDrawnHidesIt) {
    Yard yard;
    // Posts that aren't solid, on both sides of the avatar: narrow enough to leave the avatar in sight.
    for (const double x : {-0.34, 0.34}) {
        yard.builder.colored(kGreen).box({x - 0.09, 0, 0.0}, {x + 0.09, 4, 0.16});
    }
    EXPECT_TRUE(yard.drawn().shows_wall());
}

TEST(ContactCamera, LooksFromWhereTheAvatarIsInSight) {
    Yard yard;
    for (const double x : {-0.8, 0.8}) {  // screens beside it, from just behind the contact
        yard.builder.colored(kGreen).box({x - 0.1, 0, 0.4}, {x + 0.1, 9, 9});
    }
    EXPECT_GT(differing_pixels(yard.drawn().image, yard.drawn(true).image), 300);
}

TEST(ContactCamera, StaysInTheRoom) {
    Yard yard;
    yard.add_solid(kGreen, "left", {-1.2, 0, -0.32}, {-1.0, 2.4, 2});
    yard.add_solid(kGreen, "right", {1.0, 0, -0.32}, {1.2, 2.4, 2});
    yard.add_solid(kGreen, "back", {-1.2, 0, 2}, {1.2, 2.4, 2.2});
    yard.add_solid(kGreen, "roof", {-1.2, 2.3, -0.32}, {1.2, 2.4, 2.2});
    EXPECT_TRUE(yard.drawn().shows_wall());
}

}  // namespace
}  // namespace campuswalk::tools
