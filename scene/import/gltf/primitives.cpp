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

/// Where JOINTS_0 and WEIGHTS_0 are, JOINTS_1 and WEIGHTS_1, and so on.
std::vector<JointSource> joint_sources(const JsonObject& attributes) {
    std::vector<JointSource> sources;
    for (std::size_t n = 0;; ++n) {
        const auto joints = attributes.uint(("JOINTS_" + std::to_string(n)).c_str());
        const auto weights = attributes.uint(("WEIGHTS_" + std::to_string(n)).c_str());
        if (!joints || !weights) {
            return sources;
        }
        sources.push_back({*joints, *weights});
    }
}

}  // namespace

Primitives::Primitives(const Document& document, Buffers& buffers, const std::vector<GltfMaterial>& materials)
    : document_(document), buffers_(buffers), materials_(materials), accessors_(document, buffers) {
    first_.push_back(0);
    for (std::size_t mesh = 0; mesh < document.size("meshes"); ++mesh) {
        first_.push_back(first_.back() + document.item("meshes", mesh).objects("primitives").size());
    }
    past_end_ = first_.back();
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

/// Reads the targets whose weight isn't 0.
std::vector<MorphTarget> Primitives::read_targets(const JsonObject& primitive,
                                                  const std::vector<float>& weights, const RawMesh& mesh) {
    std::vector<MorphTarget> result;
    const std::vector<JsonObject> targets = primitive.objects("targets");
    for (std::size_t i = 0; i < std::min(targets.size(), weights.size()); ++i) {
        if (weights[i] == 0.0F) {
            continue;
        }
        MorphTarget& target = result.emplace_back();
        target.weight = weights[i];
        if (const auto positions = targets[i].uint("POSITION")) {
            target.positions = accessors_.vectors3(*positions);
            check_length(primitive, target.positions, mesh.positions.size(), "a target's POSITION");
        }
        const auto normals = targets[i].uint("NORMAL");
        if (normals && !mesh.normals.empty()) {
            target.normals = accessors_.vectors3(*normals);
            check_length(primitive, target.normals, mesh.normals.size(), "a target's NORMAL");
        }
    }
    return result;
}

void Primitives::deform(const JsonObject& primitive, const Deformation& deformation,
                        const std::vector<JointSet>& joints, RawMesh& out) {
    apply_morph_targets(read_targets(primitive, deformation.weights, out), out);
    if (deformation.X_node_bound.empty()) {
        return;
    }
    if (joints.empty()) {
        primitive.fail("is drawn with a skin and has no JOINTS_0 or WEIGHTS_0; re-export it");
    }
    for (const JointSet& set : joints) {
        if (set.joints.size() != out.positions.size() || set.weights.size() != out.positions.size()) {
            primitive.fail("has " + std::to_string(out.positions.size()) + " positions, " +
                           std::to_string(set.joints.size()) + " of JOINTS and " +
                           std::to_string(set.weights.size()) + " of WEIGHTS; re-export it");
        }
    }
    if (!apply_skin(deformation.X_node_bound, joints, out)) {
        primitive.fail("refers to a joint that its skin does not have; re-export it");
    }
}

std::vector<JointSet> Primitives::read_draco(const JsonObject& compression, bool skinned, RawMesh& out) {
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
    if (skinned) {
        attributes.joints = joint_sources(*ids);
    }
    return decode_draco(compression, *packed, attributes, out);
}

std::size_t Primitives::add_deformed(std::size_t mesh, Deformation deformation) {
    const std::size_t first = past_end_;
    deformed_.push_back({first, mesh, std::move(deformation)});
    past_end_ += first_[mesh + 1] - first_[mesh];
    return first;
}

Primitives::Numbered Primitives::find(std::size_t number) const {
    if (number < first_.back()) {
        const auto next = std::ranges::upper_bound(first_, number);
        const auto mesh = static_cast<std::size_t>(next - first_.begin()) - 1;
        return {mesh, number - first_[mesh], nullptr};
    }
    const auto next = std::ranges::upper_bound(deformed_, number, {}, &Deformed::first);
    const Deformed& found = *(next - 1);
    return {found.mesh, number - found.first, &found.deformation};
}

RawMesh Primitives::read(std::size_t number) {
    const Numbered found = find(number);
    const JsonObject mesh = document_.item("meshes", found.mesh);
    const std::vector<JsonObject> primitives = mesh.objects("primitives");
    const JsonObject& primitive = primitives[found.primitive];

    RawMesh out;
    out.name = mesh.string("name");
    if (primitives.size() > 1) {
        out.name += "-" + std::to_string(found.primitive);
    }
    out.material = primitive.uint("material").value_or(materials_.size() - 1);
    if (out.material >= materials_.size()) {
        primitive.fail("refers to a material that does not exist");
    }
    const auto attributes = primitive.object("attributes");
    if (!attributes) {
        primitive.fail("lacks 'attributes'");
    }
    const bool skinned = found.deformation != nullptr && !found.deformation->X_node_bound.empty();
    std::vector<JointSet> joints;
    const auto extensions = primitive.object("extensions");
    if (const auto draco = extensions ? extensions->object("KHR_draco_mesh_compression") : std::nullopt) {
        joints = read_draco(*draco, skinned, out);
    } else {
        read_attributes(primitive, *attributes, out);
        read_triangles(primitive, out);
        for (const JointSource& source : skinned ? joint_sources(*attributes) : std::vector<JointSource>()) {
            joints.push_back({accessors_.vectors4(source.joints), accessors_.vectors4(source.weights)});
        }
    }
    if (found.deformation != nullptr) {
        deform(primitive, *found.deformation, joints, out);
    }
    transform_uvs(out);
    return out;
}

}  // namespace campuswalk::scene::gltf
