#include "scene/import/gltf/draco_mesh.h"

#include <array>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#endif
#include <draco/compression/decode.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "scene/import/gltf/draco_header.h"

namespace campuswalk::scene::gltf {
namespace {

const draco::PointAttribute& attribute_of(const JsonObject& compression, const draco::Mesh& mesh,
                                          std::size_t id) {
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    if (attribute == nullptr) {
        compression.fail("refers to attribute " + std::to_string(id) + ", which its data does not contain");
    }
    return *attribute;
}

/// Calls `take(values)` with the `Components` floats of each point.
template <std::size_t Components, typename Take>
void for_each_point(const JsonObject& compression, const draco::Mesh& mesh, std::size_t id,
                    const Take& take) {
    const draco::PointAttribute& attribute = attribute_of(compression, mesh, id);
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        std::array<float, Components> values{};
        const draco::AttributeValueIndex value = attribute.mapped_index(point);
        if (value.value() >= attribute.size() ||
            !attribute.ConvertValue<float>(value, static_cast<std::int8_t>(Components), values.data())) {
            compression.fail(
                "contains an attribute that can't be decoded to numbers; export it without Draco");
        }
        take(values);
    }
}

/// Integer colours are normalized, whether or not Draco's own flag says so.
float color_scale(const draco::PointAttribute& attribute) {
    if (attribute.normalized()) {
        return 1.0F;
    }
    return attribute.data_type() == draco::DT_UINT8    ? 1.0F / 255.0F
           : attribute.data_type() == draco::DT_UINT16 ? 1.0F / 65535.0F
                                                       : 1.0F;
}

void append_colors(const JsonObject& compression, const draco::Mesh& mesh, std::size_t id, RawMesh& out) {
    const draco::PointAttribute& attribute = attribute_of(compression, mesh, id);
    const bool has_alpha = attribute.num_components() > 3;
    const float scale = color_scale(attribute);
    for_each_point<4>(compression, mesh, id, [&](const auto& c) {
        out.colors.push_back(
            to_rgba8(c[0] * scale, c[1] * scale, c[2] * scale, has_alpha ? c[3] * scale : 1.0F));
    });
}

}  // namespace

std::vector<JointSet> decode_draco(const JsonObject& compression, Bytes packed,
                                   const DracoAttributes& attributes, RawMesh& out) {
    if (const std::string reason = why_draco_too_large(packed); !reason.empty()) {
        compression.fail(reason + "; re-export it, or export without Draco");
    }
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(packed.data()), packed.size());
    draco::Decoder decoder;
    const auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) {
        compression.fail("can't be decoded (" + decoded.status().error_msg_string() +
                         "); re-export it, or export without Draco");
    }
    const draco::Mesh& mesh = *decoded.value();
    out.triangles.reserve(mesh.num_faces());
    for (draco::FaceIndex i(0); i < mesh.num_faces(); ++i) {
        const draco::Mesh::Face& face = mesh.face(i);
        out.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
    }
    for_each_point<3>(compression, mesh, attributes.position,
                      [&](const auto& p) { out.positions.emplace_back(p[0], p[1], p[2]); });
    if (attributes.normal) {
        for_each_point<3>(compression, mesh, *attributes.normal,
                          [&](const auto& n) { out.normals.emplace_back(n[0], n[1], n[2]); });
    }
    if (attributes.uv) {
        for_each_point<2>(compression, mesh, *attributes.uv,
                          [&](const auto& t) { out.uvs.emplace_back(t[0], t[1]); });
    }
    if (attributes.color) {
        append_colors(compression, mesh, *attributes.color, out);
    }
    std::vector<JointSet> sets;
    for (const JointSource& ids : attributes.joints) {
        JointSet& set = sets.emplace_back();
        const auto append_to = [](std::vector<Eigen::Vector4f>& values) {
            return [&values](const auto& v) { values.emplace_back(v[0], v[1], v[2], v[3]); };
        };
        for_each_point<4>(compression, mesh, ids.joints, append_to(set.joints));
        for_each_point<4>(compression, mesh, ids.weights, append_to(set.weights));
    }
    return sets;
}

}  // namespace campuswalk::scene::gltf
