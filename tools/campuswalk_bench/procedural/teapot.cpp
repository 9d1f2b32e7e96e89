#include "tools/campuswalk_bench/procedural/teapot.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "scene/model/weld.h"
#include "tools/campuswalk_bench/procedural/teapot_patches.h"

namespace campuswalk::tools::bench {

namespace {

using collision::TriangleMesh;
using Eigen::Vector3d;

struct Grid {
    int columns = 0;  ///< quads along u, in which consecutive control points differ
    int rows = 0;     ///< quads along v
};

Grid grid_of(std::size_t patch) {
    if (patch >= 12 && patch < 16) {
        return {11, 13};
    }
    if (patch >= 16 && patch < 20) {
        return {9, 10};
    }
    return {12, 12};
}

std::array<double, 4> bernstein(double u) {
    const double w = 1.0 - u;
    return {w * w * w, 3.0 * u * w * w, 3.0 * u * u * w, u * u * u};
}

Vector3d point_on(std::size_t patch, double u, double v) {
    const std::array<double, 4> along_u = bernstein(u);
    const std::array<double, 4> along_v = bernstein(v);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const auto& point = kTeapotControlPoints[kTeapotPatchPoints[patch][4 * row + column]];
            sum += along_v[row] * along_u[column] * Vector3d(point[0], point[1], point[2]);
        }
    }
    return sum;
}

/// Welds vertices with a tolerance: patches share edges up to rounding, and poles are single points.
class Vertices {
public:
    std::uint32_t add(const Vector3d& point) {
        constexpr double kStepsPerUnit = 1e7;
        scene::WeldTable<3>::Key key{};
        for (int i = 0; i < 3; ++i) {
            key[static_cast<std::size_t>(i)] =
                static_cast<std::uint32_t>(std::llround(point[i] * kStepsPerUnit));
        }
        const std::uint32_t number = table_.number_of(key);
        if (number == points_.size()) {
            points_.push_back(point);
        }
        return number;
    }

    std::vector<Eigen::Vector3f> centred() const {
        Vector3d low = points_.front();
        Vector3d high = low;
        for (const Vector3d& point : points_) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        const Vector3d middle = 0.5 * (low + high);
        std::vector<Eigen::Vector3f> positions;
        for (const Vector3d& point : points_) {
            positions.emplace_back((point - middle).cast<float>());
        }
        return positions;
    }

private:
    scene::WeldTable<3> table_{8192};
    std::vector<Vector3d> points_;
};

void add_triangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) {
        mesh.triangles.push_back({a, b, c});
    }
}

void add_patch(TriangleMesh& mesh, Vertices& vertices, std::size_t patch, Grid grid) {
    std::vector<std::uint32_t> indices;
    for (int row = 0; row <= grid.rows; ++row) {
        for (int column = 0; column <= grid.columns; ++column) {
            const double u = static_cast<double>(column) / grid.columns;
            const double v = static_cast<double>(row) / grid.rows;
            indices.push_back(vertices.add(point_on(patch, u, v)));
        }
    }
    const auto at = [&](int row, int column) {
        const int number = row * (grid.columns + 1) + column;
        return indices[static_cast<std::size_t>(number)];
    };
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const std::uint32_t a = at(row, column);
            const std::uint32_t b = at(row, column + 1);
            const std::uint32_t c = at(row + 1, column + 1);
            const std::uint32_t d = at(row + 1, column);
            add_triangle(mesh, a, b, c);
            add_triangle(mesh, a, c, d);
        }
    }
}

}  // namespace

TriangleMesh teapot(int fineness) {
    TriangleMesh mesh;
    Vertices vertices;
    for (std::size_t patch = 0; patch < kTeapotPatches; ++patch) {
        const Grid grid = grid_of(patch);
        add_patch(mesh, vertices, patch, {grid.columns * fineness, grid.rows * fineness});
    }
    mesh.positions = vertices.centred();
    return mesh;
}

}  // namespace campuswalk::tools::bench
