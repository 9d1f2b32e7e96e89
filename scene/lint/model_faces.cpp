#include <algorithm>
#include <array>

#include "scene/lint/model_report.h"
#include "scene/model/weld.h"

namespace campuswalk::scene {
namespace {

/// The world coordinate along `axis` of the centroid of each triangle, as drawn.
std::vector<double> triangle_centroids(const Model& model, int axis) {
    std::vector<double> centroids;
    for (const Node& node : model.nodes) {
        const Eigen::RowVector4d row = node.X_world_node.row(axis);
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            for (const auto& t : mesh.triangles) {
                const Eigen::Vector3d sum = mesh.positions[t[0]].cast<double>() +
                                            mesh.positions[t[1]].cast<double>() +
                                            mesh.positions[t[2]].cast<double>();
                centroids.push_back(row.head<3>().dot(sum.transpose()) / 3.0 + row[3]);
            }
        }
    }
    return centroids;
}

struct Interval {
    double low = 1e300;
    double high = -1e300;
};

/// The range of the values without the lowest and highest 0.5 %.
Interval central_range(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t cut = values.size() / 200;
    return {values[cut], values[values.size() - 1 - cut]};
}

Interval range_of(const Model& model, const Node& node, int axis) {
    Interval interval;
    const Eigen::RowVector4d row = node.X_world_node.row(axis);
    for (const MeshIndex index : node.meshes) {
        for (const Eigen::Vector3f& position : model.meshes[index_of(index)].positions) {
            const double value = row.head<3>().dot(position.cast<double>().transpose()) + row[3];
            interval.low = std::min(interval.low, value);
            interval.high = std::max(interval.high, value);
        }
    }
    return interval;
}

}  // namespace

std::vector<std::size_t> outlier_nodes(const Model& model) {
    constexpr double kStretch = 4.0;
    constexpr double kGroundSlack = 16.0;
    constexpr double kSame = 1e-6;              // metres
    constexpr double kMinLength = 1.0;          // metres: in a flat model a bump is no outlier
    constexpr std::size_t kMinTriangles = 400;  // with fewer, 0.5 % of them is none
    std::vector<std::size_t> outliers;
    if (count_triangles(model) < kMinTriangles) {
        return outliers;
    }
    std::vector<bool> is_outlier(model.nodes.size(), false);
    const Bounds bounds = world_bounds(model);
    std::array<Interval, 3> bulks;
    double extent = kMinLength;
    for (int axis = 0; axis < 3; ++axis) {
        bulks[static_cast<std::size_t>(axis)] = central_range(triangle_centroids(model, axis));
        const Interval& bulk = bulks[static_cast<std::size_t>(axis)];
        extent = std::max(extent, bulk.high - bulk.low);
    }
    const double slack = 0.5 * (kStretch - 1.0) * extent;
    for (int axis = 0; axis < 3; ++axis) {
        const Interval& bulk = bulks[static_cast<std::size_t>(axis)];
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            const Interval node = range_of(model, model.nodes[i], axis);
            // What the rest lies within, such as the ground, may be wider.
            const bool surrounds = node.low <= bulk.low && node.high >= bulk.high;
            const double allowed = surrounds ? kGroundSlack * slack : slack;
            const bool stretches = (node.low < bulk.low - allowed && node.low <= bounds.min[axis] + kSame) ||
                                   (node.high > bulk.high + allowed && node.high >= bounds.max[axis] - kSame);
            is_outlier[i] = is_outlier[i] || (node.low <= node.high && stretches);
        }
    }
    for (std::size_t i = 0; i < is_outlier.size(); ++i) {
        if (is_outlier[i]) {
            outliers.push_back(i);
        }
    }
    return outliers;
}

std::vector<DuplicateFaces> find_duplicate_faces(const Model& model, const Bounds& bounds) {
    const Eigen::Vector3d centre = bounds.center();
    const std::size_t triangles = count_triangles(model);
    WeldTable<3> positions(triangles);
    WeldTable<3> faces(triangles);
    std::vector<DuplicateFaces> duplicates;
    std::vector<std::uint32_t> numbers;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const Node& node = model.nodes[n];
        const Eigen::Matrix3d linear = node.X_world_node.topLeftCorner<3, 3>();
        const Eigen::Vector3d offset = node.X_world_node.topRightCorner<3, 1>() - centre;
        DuplicateFaces own{n, 0, {}};
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            numbers.clear();
            for (const Eigen::Vector3f& p : mesh.positions) {
                const Eigen::Vector3f local = (linear * p.cast<double>() + offset).cast<float>();
                numbers.push_back(positions.number_of(bits_of(local)));
            }
            for (const auto& t : mesh.triangles) {
                std::array<std::uint32_t, 3> face = {numbers[t[0]], numbers[t[1]], numbers[t[2]]};
                std::rotate(face.begin(), std::ranges::min_element(face),
                            face.end());  // keeps the winding
                if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
                    continue;  // degenerate
                }
                const std::size_t known = faces.size();
                if (faces.number_of(face) < known && own.count++ == 0) {
                    const Eigen::Vector3f sum =
                        mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
                    own.first = linear * (sum.cast<double>() / 3.0) + offset + centre;
                }
            }
        }
        if (own.count > 0) {
            duplicates.push_back(own);
        }
    }
    return duplicates;
}

}  // namespace campuswalk::scene
