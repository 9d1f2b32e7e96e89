#include "scene/import/gltf/meshopt.h"

#include <meshoptimizer.h>

namespace campuswalk::scene::gltf {
namespace {

constexpr std::size_t kMaxStride = 256;  // of the extension and of the library
// The highest possible compression ratio: a vertex block of 256 x 256 bytes has a header of 16 bytes for each
// 16.
constexpr std::size_t kMaxRatio = 1024;

struct Layout {
    std::size_t count = 0;
    std::size_t stride = 0;
    std::string mode;
    std::string filter;
};

Layout layout_of(const JsonObject& compression, std::size_t packed) {
    Layout layout;
    layout.count = compression.required_uint("count");
    layout.stride = compression.required_uint("byteStride");
    layout.mode = compression.string("mode");
    layout.filter = compression.has("filter") ? compression.string("filter") : "NONE";
    if (layout.mode != "ATTRIBUTES" && layout.mode != "TRIANGLES" && layout.mode != "INDICES") {
        compression.fail("has the mode '" + layout.mode + "', which is not supported");
    }
    const bool vertices = layout.mode == "ATTRIBUTES";
    const bool stride_fits = vertices ? layout.stride % 4 == 0 && layout.stride <= kMaxStride
                                      : layout.stride == 2 || layout.stride == 4;
    if (layout.stride == 0 || !stride_fits || (layout.mode == "TRIANGLES" && layout.count % 3 != 0)) {
        compression.fail("has a byteStride or count that is not valid for its mode");
    }
    if (layout.count > (packed + 1) * kMaxRatio) {
        compression.fail("has a count larger than its bytes can hold");
    }
    return layout;
}

void apply_filter(const JsonObject& compression, const Layout& layout, std::vector<std::uint8_t>& bytes) {
    const std::size_t stride = layout.stride;
    if (layout.filter == "NONE") {
        return;
    }
    if (layout.filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
        meshopt_decodeFilterOct(bytes.data(), layout.count, stride);
    } else if (layout.filter == "QUATERNION" && stride == 8) {
        meshopt_decodeFilterQuat(bytes.data(), layout.count, stride);
    } else if (layout.filter == "EXPONENTIAL") {
        meshopt_decodeFilterExp(bytes.data(), layout.count, stride);
    } else {
        compression.fail("has the filter '" + layout.filter + "', which is not supported for its stride");
    }
}

}  // namespace

std::vector<std::uint8_t> decode_meshopt(const JsonObject& compression, Bytes packed) {
    const Layout layout = layout_of(compression, packed.size());
    std::vector<std::uint8_t> bytes(layout.count * layout.stride);
    int failure = 0;
    if (layout.mode == "ATTRIBUTES") {
        failure = meshopt_decodeVertexBuffer(bytes.data(), layout.count, layout.stride, packed.data(),
                                             packed.size());
    } else if (layout.mode == "TRIANGLES") {
        failure = meshopt_decodeIndexBuffer(bytes.data(), layout.count, layout.stride, packed.data(),
                                            packed.size());
    } else {
        failure = meshopt_decodeIndexSequence(bytes.data(), layout.count, layout.stride, packed.data(),
                                              packed.size());
    }
    if (failure != 0) {
        compression.fail("is damaged or was encoded by a newer codec; export it without compression");
    }
    apply_filter(compression, layout, bytes);
    return bytes;
}

}  // namespace campuswalk::scene::gltf
