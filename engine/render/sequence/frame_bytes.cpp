#include "engine/render/sequence/frame_bytes.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace campuswalk::engine::render {
namespace {

struct Header {
    std::uint64_t number = 0;
    double time = 0.0;
    std::int32_t width = 0;
    std::int32_t height = 0;
};

}  // namespace

std::string serialize(const Frame& frame) {
    const Image& image = frame.image;
    const Header header = {frame.number, frame.time, image.width, image.height};
    std::string bytes(sizeof(header) + image.rgba.size(), '\0');
    std::memcpy(bytes.data(), &header, sizeof(header));
    if (!image.rgba.empty()) {
        std::memcpy(bytes.data() + sizeof(header), image.rgba.data(), image.rgba.size());
    }
    return bytes;
}

Frame deserialize_frame(std::string_view bytes) {
    Header header;
    if (bytes.size() >= sizeof(header)) {
        std::memcpy(&header, bytes.data(), sizeof(header));
        bytes.remove_prefix(sizeof(header));
    }
    Frame frame{{header.width, header.height, {}}, header.number, header.time};
    if (header.width < 1 || header.height < 1 || frame.image.offset(0, header.height) != bytes.size()) {
        throw std::runtime_error("a drawing process sent an invalid frame");
    }
    frame.image.rgba.assign(bytes.begin(), bytes.end());
    return frame;
}

}  // namespace campuswalk::engine::render
