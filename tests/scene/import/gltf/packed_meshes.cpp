#include "tests/scene/import/gltf/packed_meshes.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#endif
#include <draco/compression/encode.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#include <meshoptimizer.h>
#include <webp/encode.h>

namespace campuswalk::scene::test {

GridMesh grid_mesh(std::size_t side) {
    GridMesh mesh;
    const auto step = 1.0F / static_cast<float>(side - 1);
    const auto at = [side](std::size_t x, std::size_t z) { return static_cast<std::uint32_t>(z * side + x); };
    for (std::size_t z = 0; z < side; ++z) {
        for (std::size_t x = 0; x < side; ++x) {
            mesh.positions.insert(mesh.positions.end(),
                                  {static_cast<float>(x) * step, 0.0F, static_cast<float>(z) * step});
            if (x + 1 < side && z + 1 < side) {
                mesh.indices.insert(mesh.indices.end(), {at(x, z), at(x, z + 1), at(x + 1, z), at(x + 1, z),
                                                         at(x, z + 1), at(x + 1, z + 1)});
            }
        }
    }
    return mesh;
}

std::vector<std::uint8_t> draco_of(const GridMesh& mesh) {
    draco::Mesh packed;
    const auto points = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    packed.set_num_points(points);
    draco::GeometryAttribute position;
    position.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int id = packed.AddAttribute(position, true, points);
    for (std::uint32_t i = 0; i < points; ++i) {
        packed.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                                &mesh.positions[std::size_t{3} * i]);
    }
    if (!mesh.joints.empty()) {
        draco::GeometryAttribute four;
        four.Init(draco::GeometryAttribute::GENERIC, nullptr, 4, draco::DT_UINT8, false, 4, 0);
        const int joints = packed.AddAttribute(four, true, points);
        const int weights = packed.AddAttribute(four, true, points);
        constexpr std::array<std::uint8_t, 4> kAll = {255, 0, 0, 0};
        for (std::uint32_t i = 0; i < points; ++i) {
            packed.attribute(joints)->SetAttributeValue(draco::AttributeValueIndex(i),
                                                        &mesh.joints[std::size_t{4} * i]);
            packed.attribute(weights)->SetAttributeValue(draco::AttributeValueIndex(i), kAll.data());
        }
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        packed.AddFace({draco::PointIndex(mesh.indices[i]), draco::PointIndex(mesh.indices[i + 1]),
                        draco::PointIndex(mesh.indices[i + 2])});
    }
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 16);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(packed, &buffer).ok()) {
        return {};
    }
    return {buffer.data(), buffer.data() + buffer.size()};
}

std::vector<std::uint8_t> meshopt_vertices_of(const GridMesh& mesh) {
    constexpr std::size_t kStride = 12;
    const std::size_t count = mesh.positions.size() / 3;
    std::vector<std::uint8_t> bytes(meshopt_encodeVertexBufferBound(count, kStride));
    bytes.resize(
        meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), mesh.positions.data(), count, kStride));
    return bytes;
}

std::vector<std::uint8_t> meshopt_indices_of(const GridMesh& mesh) {
    std::vector<std::uint8_t> bytes(
        meshopt_encodeIndexBufferBound(mesh.indices.size(), mesh.positions.size() / 3));
    bytes.resize(
        meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), mesh.indices.data(), mesh.indices.size()));
    return bytes;
}

GltfText draco_gltf(const GridMesh& mesh) {
    const std::size_t count = mesh.positions.size() / 3;
    GltfText text;
    Json packing = {{"bufferView", text.add_view(draco_of(mesh))}, {"attributes", {{"POSITION", 0}}}};
    if (!mesh.joints.empty()) {
        packing["attributes"]["JOINTS_0"] = 1;
        packing["attributes"]["WEIGHTS_0"] = 2;
    }
    text.json["accessors"] = {{{"componentType", 5126}, {"count", count}, {"type", "VEC3"}},
                              {{"componentType", count > 65535 ? 5125
                                                 : count > 255 ? 5123
                                                               : 5121},
                               {"count", mesh.indices.size()},
                               {"type", "SCALAR"}}};
    text.add_node({{"name", "packed"},
                   {"mesh", text.add_mesh({{"attributes", {{"POSITION", 0}}},
                                           {"indices", 1},
                                           {"extensions", {{"KHR_draco_mesh_compression", packing}}}})}});
    text.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return text;
}

GltfText meshopt_gltf(const GridMesh& grid) {
    GltfText text;
    const std::vector<std::uint8_t> vertices = meshopt_vertices_of(grid);
    const std::vector<std::uint8_t> indices = meshopt_indices_of(grid);
    const auto pack = [&](const std::vector<std::uint8_t>& bytes, std::size_t stride, std::size_t count,
                          const char* mode) {
        const std::size_t view = text.add_view(bytes);
        Json where = text.json["bufferViews"][view];
        where["byteStride"] = stride;
        where["count"] = count;
        where["mode"] = mode;
        text.json["bufferViews"][view] = {{"buffer", 1},
                                          {"byteLength", stride * count},
                                          {"extensions", {{"EXT_meshopt_compression", where}}}};
        return view;
    };
    const std::size_t count = grid.positions.size() / 3;
    const std::size_t positions =
        text.add_accessor(pack(vertices, 12, count, "ATTRIBUTES"), 5126, count, "VEC3");
    const std::size_t indices_at = text.add_accessor(pack(indices, 4, grid.indices.size(), "TRIANGLES"), 5125,
                                                     grid.indices.size(), "SCALAR");
    text.add_node(
        {{"name", "packed"},
         {"mesh", text.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices_at}})}});
    text.json["buffers"] = {{{"byteLength", text.buffer_bytes()}}, {{"byteLength", 1'000'000}}};
    text.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    return text;
}

std::string webp_image(int width, int height, std::array<std::uint8_t, 4> rgba) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < width * height; ++i) {
        pixels.insert(pixels.end(), rgba.begin(), rgba.end());
    }
    std::uint8_t* out = nullptr;
    const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), width, height, width * 4, &out);
    std::string bytes(reinterpret_cast<const char*>(out), size);
    WebPFree(out);
    return bytes;
}

}  // namespace campuswalk::scene::test
