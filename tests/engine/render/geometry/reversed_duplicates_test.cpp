#include "engine/render/geometry/reversed_duplicates.h"

#include <algorithm>
#include <random>
#include <span>

#include <gtest/gtest.h>

#include "engine/render/renderer.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;

struct Soup {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

    std::array<std::array<float, 3>, 3> positions(std::size_t triangle) const {
        std::array<std::array<float, 3>, 3> all{};
        for (std::size_t i = 0; i < 3; ++i) {
            all[i] = vertices[indices[3 * triangle + i]].position;
        }
        return all;
    }
};

// Vertices are duplicated, as for the two sides of a sheet.
Soup random_soup(std::mt19937& random, int points, int triangles) {
    Soup soup;
    for (int copy = 0; copy < 2; ++copy) {
        for (int i = 0; i < points; ++i) {
            const double zero = copy == 0 ? 0.0 : -0.0;
            soup.vertices.push_back(
                make_vertex({i % 3 == 0 ? zero : i, 0.1 * i, zero}, Vector3d::UnitY(), Vector2f(0, 0), {}));
        }
    }
    std::uniform_int_distribution<std::uint32_t> any(0, 2 * static_cast<std::uint32_t>(points) - 1);
    for (int i = 0; i < 3 * triangles; ++i) {
        soup.indices.push_back(any(random));
    }
    return soup;
}

bool reversed(const Soup& soup, std::size_t one, std::size_t other) {
    const auto a = soup.positions(one);
    auto b = soup.positions(other);
    std::ranges::reverse(b);
    for (int turn = 0; turn < 3; ++turn) {
        if (a == b) {
            return true;
        }
        b = {b[1], b[2], b[0]};
    }
    return false;
}

TEST(ReversedDuplicates, MatchABruteForceSearch) {
    std::mt19937 random(7);
    std::size_t duplicates = 0;
    for (int round = 0; round < 50; ++round) {
        const Soup soup = random_soup(random, 4 + round / 5, 60);
        const std::vector<bool> found =
            find_reversed_duplicates(soup.vertices, soup.indices, std::vector<std::uint32_t>(60, 0));
        ASSERT_EQ(found.size(), 60U);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto p = soup.positions(i);
            if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) {
                continue;  // a degenerate triangle has no sides
            }
            bool any = false;
            for (std::size_t j = 0; j < found.size(); ++j) {
                any = any || reversed(soup, i, j);
            }
            EXPECT_EQ(found[i], any) << "round " << round << ", triangle " << i;
            duplicates += any ? 1 : 0;
        }
    }
    EXPECT_GT(duplicates, 100U);
}

TEST(ReversedDuplicates, AcceptsNoTriangles) {
    EXPECT_TRUE(find_reversed_duplicates({}, {}, {}).empty());
}

TEST(ReversedDuplicates, MustBeInTheSameGroup) {
    const std::vector<Vertex> vertices = {
        make_vertex({0, 0, 0}, {0, 1, 0}, {0, 0}, {255, 255, 255, 255}),
        make_vertex({1, 0, 0}, {0, 1, 0}, {0, 0}, {255, 255, 255, 255}),
        make_vertex({0, 0, 1}, {0, 1, 0}, {0, 0}, {255, 255, 255, 255}),
    };
    const std::vector<std::uint32_t> double_sided = {0, 1, 2, 2, 1, 0};
    EXPECT_EQ(find_reversed_duplicates(vertices, double_sided, std::vector<std::uint32_t>{5, 5}),
              (std::vector<bool>{true, true}));
    EXPECT_EQ(find_reversed_duplicates(vertices, double_sided, std::vector<std::uint32_t>{0, 5}),
              (std::vector<bool>{false, false}));
}

// A sheet as SketchUp writes it: its sides differ in colour and material, both materials are double-sided.
scene::Model sheet(const Eigen::Matrix4d& place, bool front, bool back, bool double_sided) {
    SceneBuilder builder;
    Eigen::Matrix4d turned = place;  // about its diagonal by 180°: the same triangles, seen from behind
    turned.col(0) = place.col(1);
    turned.col(1) = place.col(0);
    turned.col(2) *= -1.0;
    if (front) {
        builder.colored(kGreen).placed(place).upright({0, 0, 0}, 6.0);
        builder.material().double_sided = double_sided;
    }
    if (back) {
        builder.colored(kRed).placed(turned).upright({0, 0, 0}, 6.0);
        builder.material().double_sided = double_sided;
    }
    return builder.model();
}

TEST(ReversedDuplicates, EachShowsOnlyItsFront) {
    Eigen::Matrix4d floor = Eigen::Matrix4d::Identity();  // the sheet's +Z is up
    floor.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    const scene::Model both_sides = sheet(floor, true, true, true);
    const scene::Model upper = sheet(floor, true, false, false);
    const scene::Model lower = sheet(floor, false, true, false);
    Renderer both(std::span(&both_sides, 1), quick_settings());
    Renderer above(std::span(&upper, 1), quick_settings());
    Renderer below(std::span(&lower, 1), quick_settings());
    const Viewpoint down = looking({0.4, 3, 2}, 0.3, -0.9, kFov);
    const Viewpoint up = looking({0.4, -3, 2}, 0.3, 0.9, kFov);
    EXPECT_EQ(both.draw(down, kWidth, kHeight).rgba, above.draw(down, kWidth, kHeight).rgba);
    EXPECT_EQ(both.draw(up, kWidth, kHeight).rgba, below.draw(up, kWidth, kHeight).rgba);
}

TEST(ReversedDuplicates, OtherSheetsStayDoubleSided) {
    const auto double_sided = [](const scene::Model& model) {
        std::vector<bool> of_batches;
        for (const Batch& batch : bake(std::span(&model, 1), 20.0).batches) {
            of_batches.push_back(batch.double_sided);
        }
        return of_batches;
    };
    const Eigen::Matrix4d place = Eigen::Matrix4d::Identity();  // its two triangles are in two cells
    EXPECT_EQ(double_sided(sheet(place, true, false, true)), (std::vector{true, true}));
    EXPECT_EQ(double_sided(sheet(place, true, false, false)), (std::vector{false, false}));
    EXPECT_EQ(double_sided(sheet(place, true, true, true)), (std::vector{false, false, false, false}));
}

}  // namespace
}  // namespace campuswalk::engine::render::test
