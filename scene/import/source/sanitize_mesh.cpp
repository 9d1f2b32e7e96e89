#include "scene/import/source/sanitize_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/mesh/mesh_extent.h"
#include "scene/import/source/vertex_normals.h"
#include "scene/model/weld.h"

namespace campuswalk::scene {
namespace {

// cos 40 deg: rooms and kerbs keep sharp edges, trunks and domes are smooth.
constexpr double kCreaseCosine = 0.766044443;
constexpr double kFlat = 1.0;
constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

bool indices_in_range(const RawMesh& source) {
    return source.triangles.empty() || collision::highest_vertex(source.triangles) < source.positions.size();
}

bool positions_finite(const RawMesh& source) {
    // Fast path. Only vertices that triangles use have to be finite.
    if (std::isfinite(collision::largest_coordinate(source.positions))) {
        return true;
    }
    return std::ranges::all_of(source.triangles, [&](const auto& t) {
        return source.positions[t[0]].allFinite() && source.positions[t[1]].allFinite() &&
               source.positions[t[2]].allFinite();
    });
}

/// Makes the vertex at each position in the index buffer (3 per triangle) from the attributes of the file.
class VertexSource {
public:
    VertexSource(const RawMesh& source, bool flat_normals) : source_(source) {
        if (source.normals.empty()) {
            generated_ =
                vertex_normals(source.positions, source.triangles, flat_normals ? kFlat : kCreaseCosine);
        }
    }

    void append(std::size_t index, SanitizedMesh& out) const {
        const std::uint32_t vertex = source_.triangles[index / 3][index % 3];
        out.mesh.positions.push_back(source_.positions[vertex]);
        out.mesh.normals.push_back(normal(index, vertex, out.repaired_normals));
        if (!source_.uvs.empty()) {
            out.mesh.uvs.push_back(uv(vertex, out.repaired_uvs));
        }
        if (!source_.colors.empty()) {
            out.mesh.colors.push_back(source_.colors[vertex]);
        }
    }

private:
    Eigen::Vector3f normal(std::size_t index, std::uint32_t vertex, std::size_t& repaired) const {
        if (source_.normals.empty()) {
            return generated_[index];
        }
        const Eigen::Vector3d n = source_.normals[vertex].cast<double>();
        const double length = n.norm();
        if (std::isfinite(length) && length > 0.0) {
            return (n / length).cast<float>();
        }
        ++repaired;
        const auto& t = source_.triangles[index / 3];
        return face_normal(source_.positions[t[0]], source_.positions[t[1]], source_.positions[t[2]]);
    }

    Eigen::Vector2f uv(std::uint32_t vertex, std::size_t& repaired) const {
        const Eigen::Vector2f& t = source_.uvs[vertex];
        if (t.allFinite()) {
            return t;
        }
        ++repaired;
        return Eigen::Vector2f::Zero();
    }

    const RawMesh& source_;
    std::vector<Eigen::Vector3f> generated_;
};

/// Makes a vertex per index and welds identical ones.
void append_welded(const VertexSource& vertices, std::size_t index_count, SanitizedMesh& out) {
    WeldTable<9> welded(index_count);
    Mesh& mesh = out.mesh;
    for (std::size_t index = 0; index < index_count; ++index) {
        vertices.append(index, out);
        WeldTable<9>::Key key{};
        std::ranges::copy(bits_of(mesh.positions.back()), key.begin());
        std::ranges::copy(bits_of(mesh.normals.back()), key.begin() + 3);
        if (!mesh.uvs.empty()) {
            key[6] = bits_of(mesh.uvs.back().x());
            key[7] = bits_of(mesh.uvs.back().y());
        }
        if (!mesh.colors.empty()) {
            key[8] = std::bit_cast<std::uint32_t>(mesh.colors.back());
        }
        const std::size_t known = welded.size();
        const std::uint32_t number = welded.number_of(key);
        mesh.triangles[index / 3][index % 3] = number;
        if (number < known) {
            mesh.positions.pop_back();
            mesh.normals.pop_back();
            if (!mesh.uvs.empty()) {
                mesh.uvs.pop_back();
            }
            if (!mesh.colors.empty()) {
                mesh.colors.pop_back();
            }
        }
    }
}

/// Keeps the file's index buffer; drops unused vertices.
void append_indexed(const VertexSource& vertices, const RawMesh& source, SanitizedMesh& out) {
    const std::size_t vertex_count = source.positions.size();
    std::vector<std::uint32_t> number(vertex_count, kUnused);
    out.mesh.positions.reserve(vertex_count);
    out.mesh.normals.reserve(vertex_count);
    out.mesh.uvs.reserve(source.uvs.size());
    out.mesh.colors.reserve(source.colors.size());
    for (std::size_t index = 0; index < source.triangles.size() * 3; ++index) {
        std::uint32_t& n = number[source.triangles[index / 3][index % 3]];
        if (n == kUnused) {
            n = static_cast<std::uint32_t>(out.mesh.positions.size());
            vertices.append(index, out);
        }
        out.mesh.triangles[index / 3][index % 3] = n;
    }
}

bool all_vertices_used(const RawMesh& source) {
    std::vector<std::uint8_t> used(source.positions.size());  // faster than vector<bool>
    for (const auto& t : source.triangles) {
        used[t[0]] = 1;
        used[t[1]] = 1;
        used[t[2]] = 1;
    }
    return std::ranges::find(used, 0) == used.end();
}

bool finite_and_nonzero(std::span<const Eigen::Vector3f> normals) {
    return std::isfinite(collision::largest_coordinate(normals)) &&
           std::ranges::all_of(normals, [](const auto& n) { return n.x() != 0 || n.y() != 0 || n.z() != 0; });
}

void normalize(std::vector<Eigen::Vector3f>& normals) {
    for (Eigen::Vector3f& normal : normals) {
        const Eigen::Vector3d n = normal.cast<double>();
        normal = (n / n.norm()).cast<float>();
    }
}

/// Moves a mesh that needs no repair, as most in large files, instead of copying it. Else returns false and
/// changes nothing.
bool move_if_valid(RawMesh& source, SanitizedMesh& out) {
    const bool finite_uvs = std::ranges::all_of(source.uvs, [](const auto& uv) { return uv.allFinite(); });
    if (!finite_uvs || !finite_and_nonzero(source.normals) || !all_vertices_used(source)) {
        return false;
    }
    normalize(source.normals);
    out.mesh.positions = std::move(source.positions);
    out.mesh.normals = std::move(source.normals);
    out.mesh.uvs = std::move(source.uvs);
    out.mesh.colors = std::move(source.colors);
    out.mesh.triangles = std::move(source.triangles);
    return true;
}

}  // namespace

SanitizedMesh sanitize_mesh(RawMesh source, bool flat_normals) {
    SanitizedMesh out;
    out.mesh.name = source.name;
    if (!indices_in_range(source)) {
        out.index_out_of_range = true;
        return out;
    }
    if (!positions_finite(source)) {
        out.position_not_finite = true;
        return out;
    }
    const bool no_shared_vertices = source.positions.size() >= source.triangles.size() * 3;
    if (!source.normals.empty() && !no_shared_vertices && move_if_valid(source, out)) {
        return out;
    }
    const VertexSource vertices(source, flat_normals);
    out.mesh.triangles.resize(source.triangles.size());
    if (source.normals.empty() || no_shared_vertices) {
        append_welded(vertices, source.triangles.size() * 3, out);
    } else {
        append_indexed(vertices, source, out);
    }
    return out;
}

std::array<std::uint8_t, 4> to_rgba8(float red, float green, float blue, float alpha) {
    const auto to_byte = [](float value) {
        const float clamped = value > 0.0F ? std::min(value, 1.0F) : 0.0F;
        return static_cast<std::uint8_t>(std::lround(clamped * 255.0F));
    };
    return {to_byte(red), to_byte(green), to_byte(blue), to_byte(alpha)};
}

}  // namespace campuswalk::scene
