#include "scene/model/mesh_parts.h"

#include <array>
#include <numbers>
#include <vector>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene {

using collision::Pose;
using collision::Vec3;

std::uint32_t MeshParts::add_point(const Vec3& point) {
    mesh_.positions.emplace_back(point.cast<float>());
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshParts::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back({a, b, c});
}

void MeshParts::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
}

void MeshParts::add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::uint32_t first = add_point(a);
    add_point(b);
    add_point(c);
    add_point(d);
    add_quad(first, first + 1, first + 2, first + 3);
}

void MeshParts::add_box(const Pose& X, const Vec3& center, const Vec3& half) {
    std::array<std::uint32_t, 8> at{};  // bits 0, 1, 2: positive side in x, y, z
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3 side((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0, (i & 4U) != 0 ? 1.0 : -1.0);
        at[i] = add_point(X * (center + half.cwiseProduct(side)));
    }
    add_quad(at[1], at[3], at[7], at[5]);
    add_quad(at[0], at[4], at[6], at[2]);
    add_quad(at[2], at[6], at[7], at[3]);
    add_quad(at[0], at[1], at[5], at[4]);
    add_quad(at[4], at[5], at[7], at[6]);
    add_quad(at[0], at[2], at[3], at[1]);
}

void MeshParts::add_prism(const Pose& X, const Vec3& foot, double radius, double height, int sides) {
    std::vector<std::uint32_t> low;
    std::vector<std::uint32_t> high;
    for (int side = 0; side < sides; ++side) {
        const auto [sin, cos] = collision::sin_cos(2.0 * std::numbers::pi * side / sides);
        const Vec3 vertex = foot + Vec3(radius * cos, 0.0, radius * sin);
        low.push_back(add_point(X * vertex));
        high.push_back(add_point(X * (vertex + Vec3(0.0, height, 0.0))));
    }
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t next = (i + 1) % low.size();
        add_quad(low[i], high[i], high[next], low[next]);
    }
}

void MeshParts::add_ball(const Vec3& center, const Vec3& radii, int sides, int rings,
                         const std::function<double()>& bump) {
    const auto add_vertex = [&](int ring, int side) {
        const auto [out, up] = collision::sin_cos(std::numbers::pi * ring / rings);
        const auto [sin, cos] = collision::sin_cos(2.0 * std::numbers::pi * side / sides);
        const Vec3 direction(out * cos, up, out * sin);
        return add_point(center + bump() * radii.cwiseProduct(direction));
    };
    const std::uint32_t top = add_vertex(0, 0);
    for (int ring = 1; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            add_vertex(ring, side);
        }
    }
    const std::uint32_t bottom = add_vertex(rings, 0);
    const auto at = [&](int ring, int side) {
        return top + 1 + static_cast<std::uint32_t>((ring - 1) * sides + side % sides);
    };
    for (int side = 0; side < sides; ++side) {
        add_triangle(top, at(1, side + 1), at(1, side));
        for (int ring = 1; ring + 1 < rings; ++ring) {
            add_quad(at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side));
        }
        add_triangle(bottom, at(rings - 1, side), at(rings - 1, side + 1));
    }
}

void MeshParts::add_terrain(int cells, double low, double step,
                            const std::function<double(double x, double z)>& height) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const double x = low + step * column;
            const double z = low + step * row;
            add_point({x, height(x, z), z});
        }
    }
    const auto at = [&](int row, int column) {
        return first + static_cast<std::uint32_t>(row * (cells + 1) + column);
    };
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            add_quad(at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1));
        }
    }
}

}  // namespace campuswalk::scene
