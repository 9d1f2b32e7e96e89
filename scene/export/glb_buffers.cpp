#include "scene/export/glb_buffers.h"

#include <meshoptimizer.h>

#include <cstring>
#include <utility>

#include <nlohmann/json.hpp>

namespace campuswalk::scene {

namespace {

using Json = nlohmann::ordered_json;
using View = GlbBuffers::View;

struct Layout {
    std::size_t stride = 0;
    bool indices = false;
};

Layout layout_of(View view) {
    constexpr std::array<Layout, GlbBuffers::kViews> kLayouts = {
        {{8, false}, {12, false}, {4, false}, {8, false}, {4, false}, {2, true}, {4, true}}};
    return kLayouts[static_cast<std::size_t>(view)];
}

std::string encoded_vertices(std::string_view raw, std::size_t stride) {
    const std::size_t count = raw.size() / stride;
    std::string packed(meshopt_encodeVertexBufferBound(count, stride), '\0');
    packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(),
                                             raw.data(), count, stride));
    return packed;
}

std::vector<unsigned int> widened(std::string_view raw, std::size_t stride) {
    std::vector<unsigned int> indices(raw.size() / stride);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        std::memcpy(&indices[i], raw.data() + i * stride, stride);  // little-endian, as glTF is
    }
    return indices;
}

std::string encoded_indices(std::string_view raw, std::size_t stride) {
    const std::vector<unsigned int> indices = widened(raw, stride);
    std::string packed(meshopt_encodeIndexBufferBound(indices.size(), stride == 2 ? 0xFFFF : 0xFFFFFFFF),
                       '\0');
    packed.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(),
                                            indices.data(), indices.size()));
    return packed;
}

void pad_to_four(std::string& bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
}

}  // namespace

std::size_t GlbBuffers::append(View view, std::string_view elements) {
    std::string& raw = raw_[static_cast<std::size_t>(view)];
    const std::size_t offset = raw.size();
    raw.append(elements);
    return offset;
}

std::size_t GlbBuffers::append_image(std::string bytes) {
    images_.push_back(std::move(bytes));
    return images_.size() - 1;
}

GlbBuffers::Finished GlbBuffers::finish() {
    meshopt_encodeIndexVersion(1);  // what the extension knows
    meshopt_encodeVertexVersion(0);
    Finished out;
    Json views = Json::array();
    std::size_t unpacked = 0;
    for (std::size_t i = 0; i < kViews; ++i) {
        std::string raw = std::exchange(raw_[i], {});
        if (raw.empty()) {
            continue;
        }
        const Layout layout = layout_of(static_cast<View>(i));
        const std::string packed =
            layout.indices ? encoded_indices(raw, layout.stride) : encoded_vertices(raw, layout.stride);
        Json view = {{"buffer", 1}, {"byteOffset", unpacked}, {"byteLength", raw.size()}};
        if (!layout.indices) {
            view["byteStride"] = layout.stride;
        }
        view["target"] = layout.indices ? 34963 : 34962;
        view["extensions"]["EXT_meshopt_compression"] = {
            {"buffer", 0},
            {"byteOffset", out.bin.size()},
            {"byteLength", packed.size()},
            {"byteStride", layout.stride},
            {"count", raw.size() / layout.stride},
            {"mode", layout.indices ? "TRIANGLES" : "ATTRIBUTES"}};
        out.views[i] = views.size();
        views.push_back(std::move(view));
        unpacked += (raw.size() + 3) / 4 * 4;
        out.bin += packed;
        pad_to_four(out.bin);
    }
    out.first_image = views.size();
    for (const std::string& image : images_) {
        views.push_back({{"buffer", 0}, {"byteOffset", out.bin.size()}, {"byteLength", image.size()}});
        out.bin += image;
        pad_to_four(out.bin);
    }
    Json buffers = {{{"byteLength", out.bin.size()}}};
    if (unpacked > 0) {  // where the arrays of readers without the extension would be
        buffers.push_back(
            {{"byteLength", unpacked}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    }
    out.json = "\"buffers\":" + buffers.dump() + ",\"bufferViews\":" + views.dump();
    return out;
}

}  // namespace campuswalk::scene
