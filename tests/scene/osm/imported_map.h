#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/osm/import_map.h"
#include "tests/scene/model_files.h"
#include "tests/scene/osm/map_text.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::scene::osm {

/// Imports maps that are written as text, and measures what came out.
class ImportMap : public testing::Test {
protected:
    ImportedMap import(const std::string& xml, const std::string& name = "a.osm") {
        folder_.write(name, xml);
        MapRequest request;
        request.file = folder_.path() / name;
        request.mark.file = name;
        return import_map(request);
    }
    std::string refusal(const std::string& xml, const std::string& name = "a.osm") {
        const auto errors = test::errors_of([&] { import(xml, name); });
        return errors.empty() ? "" : std::string(errors.front().code.text());
    }

    test::TemporaryFolder folder_;
};

inline const Node* find(const Model& model, const std::string& name) {
    for (const Node& node : model.nodes) {
        if (node.name == name) {
            return &node;
        }
    }
    return nullptr;
}

inline Eigen::Vector3d vertex(const Mesh& mesh, std::uint32_t index) {
    return mesh.positions[index].cast<double>();
}

/// Calls `visit` with the vertices of all triangles of a node.
template <typename Visit>
void for_triangles(const Model& model, const Node& node, const Visit& visit) {
    for (const MeshIndex index : node.meshes) {
        const Mesh& mesh = model.meshes[index_of(index)];
        for (const auto& [a, b, c] : mesh.triangles) {
            visit(vertex(mesh, a), vertex(mesh, b), vertex(mesh, c));
        }
    }
}

inline Bounds bounds_of(const Model& model, const std::string& name) {
    Bounds bounds;
    for_triangles(model, *find(model, name), [&](const auto& a, const auto& b, const auto& c) {
        for (const Eigen::Vector3d& p : {a, b, c}) {
            bounds.extend(p);
        }
    });
    return bounds;
}

/// By Gauss' theorem; a floor at height 0 that is missing adds nothing.
inline double volume_of(const Model& model, const std::string& name) {
    double volume = 0.0;
    for_triangles(model, *find(model, name),
                  [&](const auto& a, const auto& b, const auto& c) { volume += a.dot(b.cross(c)) / 6.0; });
    return volume;
}

/// In the plan, of the triangles that face up (or down).
inline double plan_area(const Model& model, const Node& node, double side = 1.0) {
    double area = 0.0;
    for_triangles(model, node, [&](const auto& a, const auto& b, const auto& c) {
        area += std::max(0.0, side * 0.5 * (b - a).cross(c - a).y());
    });
    return area;
}

/// The heights of all faces that face up at a point of the plan (east, north), of nodes whose names begin so.
inline std::vector<double> heights_at(const Model& model, double east, double north,
                                      const std::string& prefix = "") {
    std::vector<double> heights;
    for (const Node& node : model.nodes) {
        if (!node.name.starts_with(prefix)) {
            continue;
        }
        for_triangles(model, node, [&](const auto& a, const auto& b, const auto& c) {
            const auto cross = [](const auto& o, const auto& p, double x, double z) {
                return (p.x() - o.x()) * (z - o.z()) - (p.z() - o.z()) * (x - o.x());
            };
            const double u = -cross(b, c, east, -north);  // seen from above, z points down
            const double v = -cross(c, a, east, -north);
            const double w = -cross(a, b, east, -north);
            if (u >= 0.0 && v >= 0.0 && w >= 0.0 && u + v + w > 1e-9) {
                heights.push_back((u * a.y() + v * b.y() + w * c.y()) / (u + v + w));
            }
        });
    }
    return heights;
}

/// The highest of them; NaN for none.
inline double top_at(const Model& model, double east, double north, const std::string& prefix = "") {
    const std::vector<double> heights = heights_at(model, east, north, prefix);
    return heights.empty() ? std::nan("") : *std::ranges::max_element(heights);
}

}  // namespace campuswalk::scene::osm
