#include "scene/import/gltf/primitives.h"

#include <algorithm>
#include <array>

#include "scene/import/gltf/draco_mesh.h"

namespace campuswalk::scene::gltf {
namespace {

enum class Mode : std::size_t { points, lines, line_loop, line_strip, triangles, strip, fan };

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The triangles of `count` indices `index(i)`. Every second one of a strip is reversed, so that all face the
/// same way.
template <typename Index>
Triangles assemble(Mode mode, std::size_t count, const Index& index) {
    Triangles triangles;
    if (mode == Mode::triangles) {
        triangles.reserve(count / 3);
        for (std::size_t i = 0; i + 2 < count; i += 3) {
            triangles.push_back({index(i), index(i + 1), index(i + 2)});
        }
    } else if (mode == Mode::strip) {
        for (std::size_t i = 0; i + 2 < count; ++i) {
            triangles.push_back({index(i), index(i + 1 + i % 2), index(i + 2 - i % 2)});
        }
    } else {
        for (std::size_t i = 1; i + 1 < count; ++i) {
            triangles.push_back({index(i), index(i + 1), index(0)});
        }
    }
    return triangles;
}

std::size_t points_and_lines(Mode mode, std::size_t count) {
    switch (mode) {
        case Mode::points:
        case Mode::line_loop:
            return count;
        case Mode::lines:
            return count / 2;
        default:
            return count > 0 ? count - 1 : 0;
    }
}

template <typename Vector>
void check_length(const JsonObject& primitive, const Vector& values, std::size_t count, const char* name) {
    if (!values.empty() && values.size() != count) {
        primitive.fail("has " + std::to_string(count) + " positions and " + std::to_string(values.size()) +
                       " of " + name + "; re-export it");
    }
}

}  // namespace

Primitives::Primitives(const Document& document, Buffers& buffers, const std::vector<GltfMaterial>& materials)
    : document_(document), buffers_(buffers), materials_(materials), accessors_(document, buffers) {
    first_.push_back(0);
    for (std::size_t mesh = 0; mesh < document.size("meshes"); ++mesh) {
        first_.push_back(first_.back() + document.item("meshes", mesh).objects("primitives").size());
    }
}

std::string Primitives::uv_name(const RawMesh& mesh) const {
    return "TEXCOORD_" + std::to_string(materials_[mesh.material].layout.channel);
}

void Primitives::transform_uvs(RawMesh& mesh) const {
    const TextureLayout& layout = materials_[mesh.material].layout;
    if (layout.linear.isIdentity(0.0F) && layout.offset.isZero(0.0F)) {
        return;
    }
    for (Eigen::Vector2f& uv : mesh.uvs) {
        uv = (layout.linear * uv + layout.offset).eval();
    }
}

void Primitives::read_attributes(const JsonObject& primitive, const JsonObject& attributes, RawMesh& out) {
    if (const auto position = attributes.uint("POSITION")) {
        out.positions = accessors_.vectors3(*position);
    } else {
        // Valid, but invisible: all positions are the origin.
        ++without_positions_;
        const auto names = attributes.keys();
        const std::size_t count =
            names.empty() ? 0 : accessors_.count(attributes.required_uint(names.front().c_str()));
        out.positions.assign(count, Eigen::Vector3f::Zero());
    }
    const std::size_t count = out.positions.size();
    if (const auto normal = attributes.uint("NORMAL")) {
        out.normals = accessors_.vectors3(*normal);
        check_length(primitive, out.normals, count, "NORMAL");
    }
    const std::string uv = uv_name(out);
    if (const auto uvs = attributes.uint(uv.c_str())) {
        out.uvs = accessors_.vectors2(*uvs);
        check_length(primitive, out.uvs, count, uv.c_str());
    }
    if (const auto colors = attributes.uint("COLOR_0")) {
        out.colors = accessors_.colors(*colors);
        check_length(primitive, out.colors, count, "COLOR_0");
    }
}

void Primitives::read_triangles(const JsonObject& primitive, RawMesh& out) {
    const std::size_t mode_number = primitive.uint("mode").value_or(4);
    if (mode_number > 6) {
        primitive.fail("has the mode " + std::to_string(mode_number) + ", which does not exist");
    }
    const auto mode = static_cast<Mode>(mode_number);
    const auto indices_at = primitive.uint("indices");
    const std::vector<std::uint32_t> indices =
        indices_at ? accessors_.indices(*indices_at) : std::vector<std::uint32_t>{};
    const std::size_t count = indices_at ? indices.size() : out.positions.size();
    if (mode < Mode::triangles) {
        out.points_and_lines = std::max<std::size_t>(points_and_lines(mode, count), 1);
    } else if (indices_at) {
        out.triangles = assemble(mode, count, [&](std::size_t i) { return indices[i]; });
    } else {
        out.triangles = assemble(mode, count, [](std::size_t i) { return static_cast<std::uint32_t>(i); });
    }
}

void Primitives::read_draco(const JsonObject& compression, RawMesh& out) {
    const auto ids = compression.object("attributes");
    if (!ids) {
        compression.fail("lacks 'attributes'");
    }
    const auto packed = buffers_.view(compression.required_uint("bufferView"));
    if (!packed) {
        compression.fail("has no data");
    }
    DracoAttributes attributes;
    attributes.position = ids->required_uint("POSITION");
    attributes.normal = ids->uint("NORMAL");
    attributes.uv = ids->uint(uv_name(out).c_str());
    attributes.color = ids->uint("COLOR_0");
    decode_draco(compression, *packed, attributes, out);
}

RawMesh Primitives::read(std::size_t number) {
    const auto next = std::upper_bound(first_.begin(), first_.end(), number);
    const auto mesh_index = static_cast<std::size_t>(next - first_.begin()) - 1;
    const JsonObject mesh = document_.item("meshes", mesh_index);
    const std::vector<JsonObject> primitives = mesh.objects("primitives");
    const JsonObject& primitive = primitives[number - first_[mesh_index]];

    RawMesh out;
    out.name = mesh.string("name");
    if (primitives.size() > 1) {
        out.name += "-" + std::to_string(number - first_[mesh_index]);
    }
    out.material = primitive.uint("material").value_or(materials_.size() - 1);
    if (out.material >= materials_.size()) {
        primitive.fail("refers to a material that does not exist");
    }
    const auto attributes = primitive.object("attributes");
    if (!attributes) {
        primitive.fail("lacks 'attributes'");
    }
    const auto extensions = primitive.object("extensions");
    if (const auto draco = extensions ? extensions->object("KHR_draco_mesh_compression") : std::nullopt) {
        read_draco(*draco, out);
    } else {
        read_attributes(primitive, *attributes, out);
        read_triangles(primitive, out);
    }
    transform_uvs(out);
    morphed_ += primitive.has("targets") ? 1U : 0U;
    return out;
}

}  // namespace campuswalk::scene::gltf
