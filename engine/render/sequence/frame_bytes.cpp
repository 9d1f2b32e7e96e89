#include "engine/render/sequence/frame_bytes.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace campuswalk::engine::render {
namespace {

struct Head {
    std::uint64_t number = 0;
    double time = 0.0;
    std::int32_t width = 0;
    std::int32_t height = 0;
};

}  // namespace

std::string serialize(const Frame& frame) {
    const Image& image = frame.image;
    const Head head = {frame.number, frame.time, image.width, image.height};
    std::string bytes(sizeof(head) + image.rgba.size(), '\0');
    std::memcpy(bytes.data(), &head, sizeof(head));
    if (!image.rgba.empty()) {
        std::memcpy(bytes.data() + sizeof(head), image.rgba.data(), image.rgba.size());
    }
    return bytes;
}

Frame deserialize_frame(std::string_view bytes) {
    Head head;
    if (bytes.size() >= sizeof(head)) {
        std::memcpy(&head, bytes.data(), sizeof(head));
        bytes.remove_prefix(sizeof(head));
    }
    Frame frame{{head.width, head.height, {}}, head.number, head.time};
    if (head.width < 1 || head.height < 1 || frame.image.offset(0, head.height) != bytes.size()) {
        throw std::runtime_error("a process that draws frames sent what isn't one");
    }
    frame.image.rgba.assign(bytes.begin(), bytes.end());
    return frame;
}

}  // namespace campuswalk::engine::render
