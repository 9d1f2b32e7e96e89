#include "scene/lint/intangible_nodes.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Kind = IntangibleNode::Kind;
using Found = std::vector<std::pair<std::size_t, Kind>>;

/// A ground of 20 m with a hall on it.
Model place() {
    Model model;
    test::add_box(model, "ground", {-10, -0.2, -10}, {10, 0, 10});
    test::add_box(model, "hall", {-4, 0, -4}, {4, 5, 4});
    return model;
}

/// Adds points of a sphere from `lowest` (radians) to its top, in a mesh without triangles.
std::size_t add_dome(Model& model, const std::string& name, double radius, double lowest) {
    const std::size_t node = test::add_box(model, name, {0, 0, 0}, {1, 1, 1});
    Mesh& mesh = model.meshes[index_of(model.nodes[node].meshes.front())];
    std::vector<Eigen::Vector3f> positions;
    for (int i = 0; i <= 8; ++i) {
        const double up = lowest + (0.5 * std::numbers::pi - lowest) * i / 8.0;
        for (int k = 0; k < 16; ++k) {
            const double around = 2.0 * std::numbers::pi * k / 16.0;
            positions.emplace_back((radius * Eigen::Vector3d(std::cos(up) * std::cos(around), std::sin(up),
                                                             std::cos(up) * std::sin(around)))
                                       .cast<float>());
        }
    }
    mesh.positions = positions;
    return node;
}

/// What is found, as pairs of a node and its kind.
Found found_in(const Model& model) {
    Found found;
    for (const IntangibleNode& each : intangible_nodes(model)) {
        found.emplace_back(each.node, each.kind);
    }
    return found;
}

TEST(IntangibleNodes, AreDomesAndBallsAroundEverything) {
    for (const double lowest : {0.0, -0.5 * std::numbers::pi}) {
        Model model = place();
        const std::size_t sky = add_dome(model, "Sphere.001", 60.0, lowest);
        EXPECT_EQ(found_in(model), (Found{{sky, Kind::sky}}));
    }
}

TEST(IntangibleNodes, AreNoDomesOnBuildings) {
    Model model = place();
    add_dome(model, "dome", 4.0, 0.0);
    EXPECT_EQ(found_in(model), Found{});
}

TEST(IntangibleNodes, AreSkiesByNameOnlyWhereSkiesAre) {
    Model model = place();
    const std::size_t box = test::add_box(model, "skybox", {-90, -90, -90}, {90, 90, 90});
    const std::size_t clouds = test::add_box(model, "Cloud_1", {-5, 91, -5}, {5, 92, 5});
    test::add_box(model, "sky_bridge", {-1, 0, 0}, {1, 0.2, 1});
    EXPECT_EQ(found_in(model), (Found{{box, Kind::sky}, {clouds, Kind::sky}}));
}

TEST(IntangibleNodes, AreNoTopFloorsThatAreCalledSky) {
    Model model = place();
    test::add_box(model, "Sky Lounge", {-4, 5.1, -4}, {4, 8, 4});
    EXPECT_EQ(found_in(model), Found{});
}

TEST(IntangibleNodes, HaveNothingBelowThem) {
    Model model = place();
    const std::size_t lake = test::add_box(model, "lake", {20, -0.1, 0}, {60, 0, 30});
    test::add_box(model, "island", {30, 0, 10}, {40, 1, 20}, static_cast<int>(lake));
    EXPECT_EQ(found_in(model), Found{});
}

TEST(IntangibleNodes, AreLevelWaters) {
    Model model = place();
    const std::size_t lake = test::add_box(model, "Lake_Long", {20, -0.1, 0}, {60, 0, 30});
    test::add_box(model, "Lake House", {20, 0, 40}, {24, 0.05, 44});
    test::add_box(model, "Water tower", {30, 0, 40}, {34, 20, 44});
    EXPECT_EQ(found_in(model), (Found{{lake, Kind::water}}));
}

TEST(IntangibleNodes, AreBoxesThatOpeningsWereCutWith) {
    Model model = place();
    const std::size_t cutter = test::add_box(model, "CUTTER.001", {-0.5, 0, 3.9}, {0.5, 2, 4.1});
    test::add_box(model, "watering hole", {8, 0, 8}, {9, 1, 9});
    model.meshes[index_of(model.nodes.back().meshes.front())].triangles =
        std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}};
    EXPECT_EQ(found_in(model), (Found{{cutter, Kind::operand}}));
}

TEST(IntangibleNodes, HaveNamesOfTheirOwn) {
    Model model = place();
    for (const double x : {20.0, 70.0}) {
        test::add_box(model, "water", {x, -0.1, 0}, {x + 40, 0, 30});
    }
    EXPECT_EQ(found_in(model), Found{});
}

}  // namespace
}  // namespace campuswalk::scene
