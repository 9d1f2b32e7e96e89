#include "scene/base/diagnostic_archive.h"
#include "scene/model/model_file.h"

namespace campuswalk::scene {
namespace {

template <typename Element>
void put_counted(ArchiveWriter& out, const Storage<Element>& elements) {
    out.put(std::uint64_t{elements.size()});
    out.put_aligned(std::span<const Element>(elements));
}

void put(ArchiveWriter& out, const FileRequest& request) {
    out.put_text(request.uri);
    out.put(std::uint32_t{request.image});
}

void put(ArchiveWriter& out, const Texture& texture) {
    out.put_text(texture.name);
    out.put(std::int32_t{texture.width});
    out.put(std::int32_t{texture.height});
    out.put(static_cast<std::uint32_t>(texture.wrap.u));
    out.put(static_cast<std::uint32_t>(texture.wrap.v));
    put_counted(out, texture.rgba);
}

void put(ArchiveWriter& out, const std::optional<TextureIndex>& texture) {
    out.put(std::uint32_t{texture.has_value()});
    out.put(static_cast<std::uint32_t>(texture.value_or(TextureIndex{})));
}

void put(ArchiveWriter& out, const Material& material) {
    out.put_text(material.name);
    out.put_all(std::span<const float>(material.base_color));
    out.put_all(std::span<const float>(material.emissive));
    put(out, material.base_color_texture);
    put(out, material.emissive_texture);
    put(out, material.normal_texture);
    put(out, material.metallic_roughness_texture);
    out.put(material.normal_scale);
    out.put(material.metallic);
    out.put(material.roughness);
    out.put(static_cast<std::uint32_t>(material.alpha_mode));
    out.put(material.alpha_cutoff);
    out.put(std::uint32_t{material.double_sided});
    out.put(std::uint32_t{material.unlit});
}

void put(ArchiveWriter& out, const Mesh& mesh) {
    out.put_text(mesh.name);
    out.put(static_cast<std::uint32_t>(mesh.material));
    put_counted(out, mesh.positions);
    put_counted(out, mesh.normals);
    put_counted(out, mesh.uvs);
    put_counted(out, mesh.colors);
    put_counted(out, mesh.triangles);
}

/// Without the last row of the affine transform.
void put(ArchiveWriter& out, const Node& node) {
    out.put_text(node.name);
    out.put(std::int32_t{node.parent});
    for (Eigen::Index row = 0; row < 3; ++row) {
        for (Eigen::Index column = 0; column < 4; ++column) {
            out.put(node.X_world_node(row, column));
        }
    }
    out.put(std::uint64_t{node.meshes.size()});
    out.put_all(std::span(node.meshes));
}

void put(ArchiveWriter& out, const std::optional<GeographicPlace>& place) {
    out.put(std::uint32_t{place.has_value()});
    if (place) {
        out.put(place->latitude_deg);
        out.put(place->longitude_deg);
        out.put(place->height);
        out.put_all(std::span<const double>(place->at.data(), 3));
    }
}

template <typename Item>
void put_each(ArchiveWriter& out, const std::vector<Item>& items) {
    out.put(std::uint64_t{items.size()});
    for (const Item& item : items) {
        put(out, item);
    }
}

}  // namespace

ArchiveWriter archive_model(const ImportedModel& imported) {
    ArchiveWriter out(kModelFile);
    put_each(out, imported.warnings);
    put_each(out, imported.requests);
    out.put_text(imported.model.file);
    put(out, imported.model.geographic);
    // Referenced items first, so that the reader can check indices.
    put_each(out, imported.model.textures);
    put_each(out, imported.model.materials);
    put_each(out, imported.model.meshes);
    put_each(out, imported.model.nodes);
    return out;
}

}  // namespace campuswalk::scene
