#include "scene/import/assimp/convert_mesh.h"

#include <algorithm>
#include <cmath>

#include <assimp/mesh.h>

namespace campuswalk::scene {
namespace {

std::uint8_t to_byte(float value) {
    const float clamped = value > 0.0F ? std::min(value, 1.0F) : 0.0F;  // NaN becomes 0
    return static_cast<std::uint8_t>(std::lround(clamped * 255.0F));
}

std::vector<Eigen::Vector3f> to_vectors(const aiVector3D* source, unsigned int count) {
    std::vector<Eigen::Vector3f> result;
    result.reserve(count);
    for (unsigned int i = 0; i < count; ++i) {
        result.emplace_back(source[i].x, source[i].y, source[i].z);
    }
    return result;
}

void convert_faces(const aiMesh& source, RawMesh& out) {
    out.triangles.reserve(source.mNumFaces);
    for (unsigned int i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices == 3) {
            out.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        }
    }
    out.points_and_lines = source.mNumFaces - out.triangles.size();
}

}  // namespace

RawMesh convert_mesh(const aiMesh& source, unsigned int uv_channel) {
    RawMesh out;
    const unsigned int count = source.mNumVertices;
    out.name = source.mName.C_Str();
    out.material = source.mMaterialIndex;
    convert_faces(source, out);
    out.positions = to_vectors(source.mVertices, count);
    if (source.HasNormals()) {
        out.normals = to_vectors(source.mNormals, count);
    }
    if (uv_channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && source.HasTextureCoords(uv_channel)) {
        for (unsigned int i = 0; i < count; ++i) {
            const aiVector3D& uv = source.mTextureCoords[uv_channel][i];
            out.uvs.emplace_back(uv.x, 1.0F - uv.y);  // assimp's v runs up for every format, ours down
        }
    }
    if (source.HasVertexColors(0)) {
        for (unsigned int i = 0; i < count; ++i) {
            const aiColor4D& c = source.mColors[0][i];
            out.colors.push_back({to_byte(c.r), to_byte(c.g), to_byte(c.b), to_byte(c.a)});
        }
    }
    return out;
}

}  // namespace campuswalk::scene
