#include "scene/export/glb_container.h"

#include <stdexcept>

namespace campuswalk::scene {

namespace {

void append_word(std::string& bytes, std::size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>((word >> shift) & 0xFFU);
    }
}

}  // namespace

std::string glb_container(std::string json, std::span<const std::string> bin) {
    constexpr std::size_t kHeader = 12;
    constexpr std::size_t kChunkHeader = 8;
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::size_t length = 0;
    for (const std::string& part : bin) {
        length += part.size();
    }
    const std::size_t total = kHeader + kChunkHeader + json.size() + kChunkHeader + length;
    if (total > 0xFFFFFFFF) {
        throw std::runtime_error("the model is too large for one GLB file (4 GB)");
    }
    std::string bytes = "glTF";
    bytes.reserve(total);
    append_word(bytes, 2);
    append_word(bytes, total);
    append_word(bytes, json.size());
    bytes += "JSON" + json;
    append_word(bytes, length);
    bytes.append("BIN\0", 4);
    for (const std::string& part : bin) {
        bytes += part;
    }
    return bytes;
}

}  // namespace campuswalk::scene
