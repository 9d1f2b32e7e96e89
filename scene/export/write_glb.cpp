#include "scene/export/write_glb.h"

#include <meshoptimizer.h>

#include <cmath>
#include <cstring>
#include <utility>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "scene/export/export_materials.h"
#include "scene/export/glb_buffers.h"
#include "scene/export/glb_container.h"
#include "scene/export/simplify_group.h"

namespace campuswalk::scene {

using Eigen::Vector3d;

namespace {

using Json = nlohmann::ordered_json;
using View = GlbBuffers::View;

constexpr double kStep = 2e-3;  // metres: of positions, unless they are exact
constexpr int kFloat = 5126;
constexpr int kByte = 5120;
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;

template <typename Element>
std::string_view bytes_of(const std::vector<Element>& elements) {
    return {reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element)};
}

/// Positions of a group as the file has them, and where that puts the node.
struct PackedPositions {
    View view = View::positions_float;
    std::string bytes;
    Vector3d translation = Vector3d::Zero();
    double scale = 1.0;
    std::array<double, 3> min = {};
    std::array<double, 3> max = {};
};

Eigen::AlignedBox3f bounds_of(const MeshGroup& group) {
    Eigen::AlignedBox3f box;
    for (const ExportVertex& vertex : group.vertices) {
        box.extend(Eigen::Vector3f(vertex.position.data()));
    }
    return box;
}

PackedPositions packed_floats(const MeshGroup& group) {
    const Eigen::AlignedBox3f box = bounds_of(group);
    PackedPositions packed;
    packed.translation = group.origin;
    std::vector<std::array<float, 3>> positions;
    positions.reserve(group.vertices.size());
    for (const ExportVertex& vertex : group.vertices) {
        positions.push_back(vertex.position);
    }
    packed.bytes = bytes_of(positions);
    for (std::size_t k = 0; k < 3; ++k) {
        packed.min[k] = static_cast<double>(box.min()[static_cast<Eigen::Index>(k)]);
        packed.max[k] = static_cast<double>(box.max()[static_cast<Eigen::Index>(k)]);
    }
    return packed;
}

/// In whole steps of the world, so that neighbours still meet; as floats where 16 bits don't reach.
PackedPositions packed_steps(const MeshGroup& group) {
    constexpr double kMost = 65535.0;
    const Eigen::AlignedBox3f box = bounds_of(group);
    const Vector3d low = (box.min().cast<double>() / kStep).array().round();
    const Vector3d high = (box.max().cast<double>() / kStep).array().round();
    if ((high - low).maxCoeff() > kMost) {
        return packed_floats(group);
    }
    PackedPositions packed;
    packed.view = View::positions_16;
    packed.scale = kStep;
    packed.translation = group.origin + low * kStep;
    std::vector<std::array<std::uint16_t, 4>> positions;
    positions.reserve(group.vertices.size());
    for (const ExportVertex& vertex : group.vertices) {
        std::array<std::uint16_t, 4>& position = positions.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            position[k] =
                static_cast<std::uint16_t>(std::round(static_cast<double>(vertex.position[k]) / kStep) -
                                           low[static_cast<Eigen::Index>(k)]);
        }
    }
    packed.bytes = bytes_of(positions);
    for (std::size_t k = 0; k < 3; ++k) {
        packed.max[k] = high[static_cast<Eigen::Index>(k)] - low[static_cast<Eigen::Index>(k)];
    }
    return packed;
}

/// In an order that compresses and draws well.
void reorder(MeshGroup& group) {
    std::vector<std::uint32_t> indices(group.indices.size());
    meshopt_optimizeVertexCache(indices.data(), group.indices.data(), indices.size(), group.vertices.size());
    std::vector<ExportVertex> vertices(group.vertices.size());
    vertices.resize(meshopt_optimizeVertexFetch(vertices.data(), indices.data(), indices.size(),
                                                group.vertices.data(), group.vertices.size(),
                                                sizeof(ExportVertex)));
    group.indices = std::move(indices);
    group.vertices = std::move(vertices);
}

/// Builds the file's accessors, meshes and nodes; the buffer views are known only at the end.
class GlbBuilder {
public:
    GlbBuilder(bool rounded, GlbBuffers& buffers) : rounded_(rounded), buffers_(buffers) {}

    void add(const MeshGroup& group) {
        const PackedPositions positions = rounded_ ? packed_steps(group) : packed_floats(group);
        const bool shorts = positions.view == View::positions_16;
        const std::size_t count = group.vertices.size();
        Json position =
            accessor(positions.view, positions.bytes, count, shorts ? kUnsignedShort : kFloat, "VEC3", false);
        position["min"] = positions.min;
        position["max"] = positions.max;
        Json attributes = {{"POSITION", keep(positions.view, std::move(position))}};
        if (!group.is_flat) {
            attributes["NORMAL"] = add_attribute(group, View::normals, kByte, "VEC3", &ExportVertex::normal);
        }
        if (group.has_uvs) {
            attributes["TEXCOORD_0"] = add_attribute(group, View::uvs, kFloat, "VEC2", &ExportVertex::uv);
        }
        if (group.has_colors) {
            attributes["COLOR_0"] =
                add_attribute(group, View::colors, kUnsignedByte, "VEC4", &ExportVertex::color);
        }
        meshes_.push_back({{"primitives",
                            {{{"attributes", std::move(attributes)},
                              {"indices", add_indices(group)},
                              {"material", group.material}}}}});
        add_node(group, positions);
    }

    std::string file(const ExportMaterials& materials) {
        GlbBuffers::Finished finished = buffers_.finish();
        for (std::size_t i = 0; i < accessors_.size(); ++i) {
            accessors_[i]["bufferView"] = finished.views[static_cast<std::size_t>(accessor_views_[i])];
        }
        std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"campuswalk\"}," + extensions() +
                           ",\"scene\":0,\"scenes\":[" + scene() + "]";
        const std::string lists[] = {list("nodes", nodes_), list("meshes", meshes_),
                                     list("accessors", accessors_)};
        for (const std::string& each : lists) {
            json += each;
        }
        json += "," + materials.json(finished.first_image) + "," + finished.json + "}";
        return glb_container(std::move(json), std::span(&finished.bin, 1));
    }

private:
    Json accessor(View view, std::string_view bytes, std::size_t count, int component, const char* type,
                  bool normalized) {
        Json json = {{"bufferView", 0},
                     {"byteOffset", buffers_.append(view, bytes)},
                     {"componentType", component},
                     {"count", count},
                     {"type", type}};
        if (normalized) {
            json["normalized"] = true;
        }
        return json;
    }

    std::size_t keep(View view, Json accessor) {
        accessors_.push_back(std::move(accessor));
        accessor_views_.push_back(view);
        return accessors_.size() - 1;
    }

    template <typename Member>
    std::size_t add_attribute(const MeshGroup& group, View view, int component, const char* type,
                              Member ExportVertex::*member) {
        std::vector<Member> values;
        values.reserve(group.vertices.size());
        for (const ExportVertex& vertex : group.vertices) {
            values.push_back(vertex.*member);
        }
        return keep(view,
                    accessor(view, bytes_of(values), values.size(), component, type, component != kFloat));
    }

    std::size_t add_indices(const MeshGroup& group) {
        if (group.vertices.size() <= 0xFFFF) {
            const std::vector<std::uint16_t> narrow(group.indices.begin(), group.indices.end());
            return keep(View::indices_16, accessor(View::indices_16, bytes_of(narrow), narrow.size(),
                                                   kUnsignedShort, "SCALAR", false));
        }
        return keep(View::indices_32, accessor(View::indices_32, bytes_of(group.indices),
                                               group.indices.size(), kUnsignedInt, "SCALAR", false));
    }

    void add_node(const MeshGroup& group, const PackedPositions& positions) {
        Json extras = {{"objects", group.tags}};
        if (!group.node.empty()) {
            extras["node"] = group.node;
        }
        const Vector3d& at = positions.translation;
        Json node = {{"mesh", meshes_.size() - 1}, {"translation", {at.x(), at.y(), at.z()}}};
        if (positions.scale != 1.0) {
            node["scale"] = {positions.scale, positions.scale, positions.scale};
        }
        node["extras"] = std::move(extras);
        nodes_.push_back(std::move(node));
    }

    std::string scene() const {
        std::string roots;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            roots += (i == 0 ? "" : ",") + std::to_string(i);
        }
        return roots.empty() ? "{}" : "{\"nodes\":[" + roots + "]}";
    }

    std::string extensions() const {
        Json required = {"EXT_meshopt_compression", "EXT_texture_webp", "KHR_mesh_quantization"};
        Json used = required;
        used.push_back("KHR_materials_unlit");
        used.push_back("KHR_materials_emissive_strength");
        return "\"extensionsUsed\":" + used.dump() + ",\"extensionsRequired\":" + required.dump();
    }

    /// glTF's lists may not be empty. Names of files need not be UTF-8.
    static std::string list(const char* name, const std::vector<Json>& items) {
        std::string text;
        for (const Json& item : items) {
            text += (text.empty() ? "" : ",") + item.dump(-1, ' ', false, Json::error_handler_t::replace);
        }
        return text.empty() ? "" : ",\"" + std::string(name) + "\":[" + text + "]";
    }

    bool rounded_;
    GlbBuffers& buffers_;
    std::vector<Json> accessors_;
    std::vector<View> accessor_views_;
    std::vector<Json> meshes_;
    std::vector<Json> nodes_;
};

}  // namespace

GlbFile write_glb(std::span<const Model> models, const GlbSettings& settings,
                  const std::function<Tags(std::size_t model, std::size_t node)>& tags_of) {
    GlbBuffers buffers;
    ExportMaterials materials(models, settings.texture_size, buffers);
    const bool simplified = settings.error > 0.0;
    GroupSettings grouping;
    grouping.step = simplified ? kStep : 0.0;
    grouping.tags_of = tags_of;
    grouping.material_of = [&](std::size_t model, MaterialIndex material) {
        return materials.number_of(model, material);
    };
    GlbFile file;
    GlbBuilder builder(simplified, buffers);
    for (MeshGroup& group : group_triangles(models, grouping)) {
        file.source_triangles += group.indices.size() / 3;
        if (simplified) {
            simplify(group, settings.error - kStep);  // that much may have gone into rounding
        }
        reorder(group);
        file.triangles += group.indices.size() / 3;
        builder.add(group);
        group = {};
    }
    file.bytes = builder.file(materials);
    return file;
}

}  // namespace campuswalk::scene
