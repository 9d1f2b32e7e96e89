#include "scene/osm/geometry/heights.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/scene/model_files.h"
#include "tests/scene/osm/imported_map.h"
#include "tests/scene/osm/map_text.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::scene::osm {
namespace {

using test::MapText;

class Heights : public testing::Test {
protected:
    /// Of a map of 20 km about 60 degrees north and 11 east.
    Terrain terrain(const std::string& grid, const std::string& name = "a.asc") {
        folder_.write(name, grid);
        Map map;
        map.geographic = {59.9, 10.8, 60.1, 11.2};
        map.box = {{-10'000, -10'000}, {10'000, 10'000}};
        SourceMark mark;
        mark.file = name;
        return read_heights(folder_.path() / name, mark, map, map.box);
    }

    test::TemporaryFolder folder_;
};

/// A grid about the map whose heights are `of(longitude, latitude)`.
template <typename Height>
std::string grid_of(const Height& of, const std::string& header = "") {
    constexpr double kStep = 0.005;
    std::string text = "ncols 121\nnrows 81\nxllcenter 10.7\nyllcenter 59.8\ncellsize 0.005\n" + header;
    for (int row = 80; row >= 0; --row) {
        for (int column = 0; column < 121; ++column) {
            text += of(10.7 + column * kStep, 59.8 + row * kStep) + " ";
        }
        text += "\n";
    }
    return text;
}

struct At {
    double east;
    double north;
    double longitude;
    double latitude;
};

TEST_F(Heights, AreWhereTheEarthHasThem) {
    // Inverse of PROJ 9.1: proj -I +proj=ortho +lat_0=60 +lon_0=11 +ellps=WGS84.
    const std::vector<At> places = {{8000, 8000, 11.1436804552, 60.0717270209},
                                    {-9000, 7000, 10.8384034419, 60.0627307520},
                                    {5000, -9000, 11.0893878567, 59.9191881214}};
    // 10 m a thousandth of a degree east (56 m) or north (111 m): 1 m of height is 5.6 or 11 m of the plan.
    const Terrain eastwards =
        terrain(grid_of([](double longitude, double) { return std::to_string(1e4 * (longitude - 11.0)); }));
    const Terrain northwards =
        terrain(grid_of([](double, double latitude) { return std::to_string(1e4 * (latitude - 60.0)); }));
    for (const At& at : places) {
        EXPECT_NEAR(eastwards.height({at.east, at.north}), 1e4 * (at.longitude - 11.0), 0.05) << at.east;
        EXPECT_NEAR(northwards.height({at.east, at.north}), 1e4 * (at.latitude - 60.0), 0.05) << at.east;
    }
}

TEST_F(Heights, MayBeMissingBesideTheMap) {
    const auto holed = [](double longitude, double) -> std::string {
        return longitude > 11.25 ? "nan" : "7";
    };
    EXPECT_EQ(terrain(grid_of(holed, "NODATA_value nan\n")).height({500, 500}), 0.0);
    EXPECT_EQ(terrain(grid_of(holed)).height({500, 500}), 0.0);
    const auto errors = test::errors_of([&] {
        terrain(
            grid_of([](double longitude, double) -> std::string { return longitude > 11.0 ? "nan" : "7"; }));
    });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].code.text(), "bad-heights");
}

TEST_F(Heights, TakeTheirFormFromTheGivenName) {
    folder_.write("link-target", grid_of([](double, double) { return std::string("3"); }));
    Map map;
    map.geographic = {59.9, 10.8, 60.1, 11.2};
    map.box = {{-100, -100}, {100, 100}};
    SourceMark mark;
    mark.file = "heights.asc";
    EXPECT_EQ(read_heights(folder_.path() / "link-target", mark, map, map.box).height({0, 0}), 0.0);
    mark.file = "N-5E011.hgt";
    EXPECT_EQ(test::errors_of([&] { read_heights(folder_.path() / "link-target", mark, map, map.box); })[0]
                  .code.text(),
              "bad-heights");
}

TEST_F(ImportMap, HasNoWindowsBelowTheGround) {
    for (const bool uphill : {false, true}) {
        MapText map;
        const auto hall =
            map.rectangle(-30, 0, 30, 40, {{"building", "university"}, {"building:levels", "3"}});
        if (uphill) {  // the ground rises by 4 m to the south of the building
            map.way({{0, -12}, {0, -2}}, {{"highway", "steps"}, {"step_count", "25"}, {"incline", "up"}});
        }
        map.way({{-60, -40}, {60, -40}}, {{"highway", "footway"}});
        const Model model = import(map.xml()).model;
        const std::string name = "building/way-" + std::to_string(hall);
        std::size_t windows = 0;
        const Node& node = *find(model, name);
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            const Material& material = model.materials[index_of(mesh.material)];
            for (const auto& [a, b, c] : mesh.triangles) {
                const Eigen::Vector3d middle = (vertex(mesh, a) + vertex(mesh, b) + vertex(mesh, c)) / 3.0;
                const bool window = material.base_color[2] > 1.2F * material.base_color[0];
                if (window) {
                    ++windows;
                    const Eigen::Vector3d low =
                        vertex(mesh, a).cwiseMin(vertex(mesh, b)).cwiseMin(vertex(mesh, c));
                    EXPECT_GT(low.y() + 0.01, top_at(model, middle.x(), -middle.z(), "ground"))
                        << middle.transpose();
                }
            }
        }
        EXPECT_GT(windows, 20U);
    }
}

}  // namespace
}  // namespace campuswalk::scene::osm
