#include "tests/engine/render/pixel_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

struct FlatTriangle {
    std::array<Vector3d, 3> vertices;  // counter-clockwise seen from outside
    std::array<Eigen::Vector2d, 3> uvs;
    std::uint32_t node = 0;
    const scene::Material* material = nullptr;
    const scene::Texture* texture = nullptr;
};

std::vector<FlatTriangle> triangles_of(const scene::Model& model) {
    std::vector<FlatTriangle> all;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const scene::Node& node = model.nodes[n];
        for (const scene::MeshIndex index : node.meshes) {
            const scene::Mesh& mesh = model.meshes[index_of(index)];
            for (const std::array<std::uint32_t, 3>& t : mesh.triangles) {
                FlatTriangle& triangle = all.emplace_back();
                for (std::size_t k = 0; k < 3; ++k) {
                    triangle.vertices[k] =
                        (node.X_world_node * mesh.positions[t[k]].cast<double>().homogeneous()).head<3>();
                    triangle.uvs[k] = mesh.uvs[t[k]].cast<double>();
                }
                triangle.node = static_cast<std::uint32_t>(n + 1);
                triangle.material = &model.materials[index_of(mesh.material)];
                if (triangle.material->base_color_texture) {
                    triangle.texture = &model.textures[index_of(*triangle.material->base_color_texture)];
                }
            }
        }
    }
    return all;
}

double alpha_at(const FlatTriangle& triangle, const Vector3d& barycentric) {
    double alpha = triangle.material->base_color[3];
    if (triangle.texture != nullptr) {
        Eigen::Vector2d uv(0, 0);
        for (std::size_t k = 0; k < 3; ++k) {
            uv += barycentric[static_cast<Eigen::Index>(k)] * triangle.uvs[k];
        }
        const scene::Texture& texture = *triangle.texture;
        const int x = std::clamp(static_cast<int>(uv.x() * texture.width), 0, texture.width - 1);
        const int y = std::clamp(static_cast<int>(uv.y() * texture.height), 0, texture.height - 1);
        const int alpha_byte = 4 * (y * texture.width + x) + 3;
        alpha *= texture.rgba[static_cast<std::size_t>(alpha_byte)] / 255.0;
    }
    return alpha;
}

bool is_visible(const FlatTriangle& triangle, const Vector3d& barycentric, const Vector3d& direction) {
    const Vector3d outside =
        (triangle.vertices[1] - triangle.vertices[0]).cross(triangle.vertices[2] - triangle.vertices[0]);
    if (!triangle.material->double_sided && outside.dot(direction) >= 0.0) {
        return false;
    }
    switch (triangle.material->alpha_mode) {
        case scene::AlphaMode::mask:
            return alpha_at(triangle, barycentric) >= triangle.material->alpha_cutoff;
        case scene::AlphaMode::blend:
            return alpha_at(triangle, barycentric) >= 0.5;
        case scene::AlphaMode::opaque:
            break;
    }
    return true;
}

// Intersects the plane, then tests the barycentric coordinates.
void intersect(const FlatTriangle& triangle, const Vector3d& from, const Vector3d& direction,
               const Vector3d& axis, double nearest, PixelHit& hit) {
    const auto& [a, b, c] = triangle.vertices;
    const Vector3d normal = (b - a).cross(c - a);
    const double slope = normal.dot(direction);
    if (slope == 0.0) {
        return;
    }
    const double t = normal.dot(a - from) / slope;
    const double depth = t * direction.dot(axis);
    if (depth < nearest || (hit.node != 0 && depth > hit.depth)) {
        return;
    }
    const Vector3d p = from + t * direction;
    const double area = normal.squaredNorm();
    const Vector3d barycentric(normal.dot((c - b).cross(p - b)) / area,
                               normal.dot((a - c).cross(p - c)) / area,
                               normal.dot((b - a).cross(p - a)) / area);
    if (barycentric.minCoeff() >= 0.0 && is_visible(triangle, barycentric, direction)) {
        hit = {triangle.node, depth, (slope > 0.0 ? -1.0 : 1.0) * normal.normalized()};
    }
}

}  // namespace

PixelRays::PixelRays(const scene::Model& model, const Viewpoint& view, int width, int height)
    : width_(width), height_(height) {
    const std::vector<FlatTriangle> triangles = triangles_of(model);
    const Vector3d right = view.R_world_camera.col(0);
    const Vector3d up = view.R_world_camera.col(1);
    const Vector3d axis = -view.R_world_camera.col(2);
    const bool perspective = view.projection == Projection::perspective;
    const double half = perspective ? std::tan(0.5 * view.fov) : 0.5 * view.height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vector3d offset = half * ((2.0 * (x + 0.5) / width - 1.0) * width / height * right +
                                            (1.0 - 2.0 * (y + 0.5) / height) * up);
            const Vector3d from = perspective ? view.position : Vector3d(view.position + offset);
            const Vector3d direction = perspective ? Vector3d(axis + offset) : axis;
            PixelHit& hit = hits_.emplace_back();
            for (const FlatTriangle& triangle : triangles) {
                intersect(triangle, from, direction, axis, view.near_distance, hit);
            }
        }
    }
}

bool PixelRays::is_interior(int x, int y) const {
    if (x < 1 || y < 1 || x + 1 >= width_ || y + 1 >= height_) {
        return false;
    }
    for (int v = y - 1; v <= y + 1; ++v) {
        for (int u = x - 1; u <= x + 1; ++u) {
            if (at(u, v).node != at(x, y).node) {
                return false;
            }
        }
    }
    return true;
}

double PixelRays::depth_change(int x, int y) const {
    double largest = 0.0;
    for (const auto& [u, v] :
         {std::pair(x - 1, y), std::pair(x + 1, y), std::pair(x, y - 1), std::pair(x, y + 1)}) {
        largest = std::max(largest, std::abs(at(u, v).depth - at(x, y).depth));
    }
    return largest;
}

}  // namespace campuswalk::engine::render::test
