#include "scene/import/convert_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <assimp/mesh.h>

#include "scene/import/corner_normals.h"
#include "scene/weld.h"

namespace campuswalk::scene {
namespace {

// cos 40 deg: keeps the corners of rooms and kerbs sharp, makes trunks and domes round.
constexpr double kCreaseCosine = 0.766044443;
constexpr double kFlat = 1.0;
constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

using Triangle = std::array<std::uint32_t, 3>;

Eigen::Vector3f to_vector(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

std::uint8_t to_byte(float value) {
    const float clamped = value > 0.0F ? std::min(value, 1.0F) : 0.0F;  // NaN becomes 0
    return static_cast<std::uint8_t>(std::lround(clamped * 255.0F));
}

/// The triangles as the file has them; false when an index points past the vertices.
bool collect_triangles(const aiMesh& source, std::vector<Triangle>& triangles) {
    triangles.reserve(source.mNumFaces);
    for (unsigned int i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        for (unsigned int k = 0; k < face.mNumIndices; ++k) {
            if (face.mIndices[k] >= source.mNumVertices) {
                return false;
            }
        }
        if (face.mNumIndices == 3) {
            triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        }
    }
    return true;
}

/// One vertex of a triangle's corner, made of whatever the file has for it.
class VertexSource {
public:
    VertexSource(const aiMesh& source, const MeshStyle& style, const std::vector<Triangle>& triangles)
        : source_(source), triangles_(triangles) {
        if (style.uv_channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && source.HasTextureCoords(style.uv_channel)) {
            uvs_ = source.mTextureCoords[style.uv_channel];
        }
        if (!source.HasNormals()) {
            positions_.reserve(source.mNumVertices);
            for (unsigned int i = 0; i < source.mNumVertices; ++i) {
                positions_.push_back(to_vector(source.mVertices[i]));
            }
            generated_ = corner_normals(positions_, triangles, style.flat_normals ? kFlat : kCreaseCosine);
        }
    }

    bool has_uvs() const { return uvs_ != nullptr; }
    bool has_generated_normals() const { return !source_.HasNormals(); }

    /// Appends the vertex of corner `corner` (3 a triangle) to the converted mesh.
    void append(std::size_t corner, ConvertedMesh& out) const {
        const std::uint32_t vertex = triangles_[corner / 3][corner % 3];
        out.mesh.positions.push_back(to_vector(source_.mVertices[vertex]));
        out.mesh.normals.push_back(normal(corner, vertex, out.repaired_normals));
        if (uvs_ != nullptr) {
            out.mesh.uvs.push_back(uv(vertex, out.repaired_uvs));
        }
        if (source_.HasVertexColors(0)) {
            const aiColor4D& c = source_.mColors[0][vertex];
            out.mesh.colors.push_back({to_byte(c.r), to_byte(c.g), to_byte(c.b), to_byte(c.a)});
        }
    }

private:
    Eigen::Vector3f normal(std::size_t corner, std::uint32_t vertex, std::size_t& repaired) const {
        if (has_generated_normals()) {
            return generated_[corner];
        }
        const Eigen::Vector3d n = to_vector(source_.mNormals[vertex]).cast<double>();
        const double length = n.norm();
        if (std::isfinite(length) && length > 0.0) {
            return (n / length).cast<float>();
        }
        ++repaired;
        const Triangle& t = triangles_[corner / 3];
        return face_normal(to_vector(source_.mVertices[t[0]]), to_vector(source_.mVertices[t[1]]),
                           to_vector(source_.mVertices[t[2]]));
    }

    Eigen::Vector2f uv(std::uint32_t vertex, std::size_t& repaired) const {
        const aiVector3D& t = uvs_[vertex];
        if (!std::isfinite(t.x) || !std::isfinite(t.y)) {
            ++repaired;
            return Eigen::Vector2f::Zero();
        }
        return {t.x, 1.0F - t.y};  // assimp's v runs up for every format, ours down
    }

    const aiMesh& source_;
    const std::vector<Triangle>& triangles_;
    const aiVector3D* uvs_ = nullptr;
    std::vector<Eigen::Vector3f> positions_;
    std::vector<Eigen::Vector3f> generated_;
};

/// Every corner makes a vertex; equal ones are joined.
void append_welded(const VertexSource& vertices, std::size_t corners, ConvertedMesh& out) {
    WeldTable<9> welded(corners);
    Mesh& mesh = out.mesh;
    for (std::size_t corner = 0; corner < corners; ++corner) {
        vertices.append(corner, out);
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
        mesh.triangles[corner / 3][corner % 3] = number;
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

/// The file's own sharing of vertices is kept; only those that no triangle uses are dropped.
void append_indexed(const VertexSource& vertices, const std::vector<Triangle>& triangles,
                    std::size_t vertex_count, ConvertedMesh& out) {
    std::vector<std::uint32_t> number(vertex_count, kUnused);
    out.mesh.positions.reserve(vertex_count);
    out.mesh.normals.reserve(vertex_count);
    out.mesh.uvs.reserve(vertices.has_uvs() ? vertex_count : 0);
    for (std::size_t corner = 0; corner < triangles.size() * 3; ++corner) {
        std::uint32_t& n = number[triangles[corner / 3][corner % 3]];
        if (n == kUnused) {
            n = static_cast<std::uint32_t>(out.mesh.positions.size());
            vertices.append(corner, out);
        }
        out.mesh.triangles[corner / 3][corner % 3] = n;
    }
}

}  // namespace

ConvertedMesh convert_mesh(const aiMesh& source, const MeshStyle& style) {
    ConvertedMesh out;
    out.mesh.name = source.mName.C_Str();
    std::vector<Triangle> triangles;
    if (!collect_triangles(source, triangles)) {
        out.index_out_of_range = true;
        return out;
    }
    out.points_and_lines = source.mNumFaces - triangles.size();
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (!to_vector(source.mVertices[vertex]).allFinite()) {
                out.position_not_finite = true;
                return out;
            }
        }
    }
    const VertexSource vertices(source, style, triangles);
    out.mesh.triangles.resize(triangles.size());
    const bool every_corner_its_own = source.mNumVertices >= triangles.size() * 3;
    if (vertices.has_generated_normals() || every_corner_its_own) {
        append_welded(vertices, triangles.size() * 3, out);
    } else {
        append_indexed(vertices, triangles, source.mNumVertices, out);
    }
    return out;
}

void flip_winding(Mesh& mesh) {
    for (auto& triangle : mesh.triangles) {
        std::swap(triangle[1], triangle[2]);
    }
}

}  // namespace campuswalk::scene
