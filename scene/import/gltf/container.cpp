#include "scene/import/gltf/container.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace campuswalk::scene::gltf {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'g', 'l', 'T', 'F'};
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kFileHeader = 12;
constexpr std::size_t kChunkHeader = 8;

std::uint32_t word_at(Bytes bytes, std::size_t at) {
    return bytes[at] | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16U |
           static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

/// Removes the next chunk from `rest`.
Bytes next_chunk(Bytes& rest, std::uint32_t& type) {
    if (rest.size() < kChunkHeader) {
        throw GltfError("it ends inside a GLB chunk header; re-export or copy the file again");
    }
    const std::uint32_t length = word_at(rest, 0);
    type = word_at(rest, 4);
    rest = rest.subspan(kChunkHeader);
    if (length > rest.size()) {
        throw GltfError("it ends inside a GLB chunk; re-export or copy the file again");
    }
    const Bytes chunk = rest.first(length);
    rest = rest.subspan(length);
    return chunk;
}

void split_glb(Bytes file, Container& out) {
    if (file.size() < kFileHeader) {
        throw GltfError("it ends inside the GLB header; re-export or copy the file again");
    }
    if (word_at(file, 4) != kVersion) {
        throw GltfError("it is GLB version " + std::to_string(word_at(file, 4)) +
                        "; only version 2 is supported: convert it to glTF 2.0");
    }
    const std::uint32_t length = word_at(file, 8);
    if (length > file.size() || length < kFileHeader) {
        throw GltfError("its header declares " + std::to_string(length) + " bytes, but the file has " +
                        std::to_string(file.size()) + "; re-export or copy it again");
    }
    Bytes rest = file.subspan(kFileHeader, length - kFileHeader);
    std::uint32_t type = 0;
    out.json = next_chunk(rest, type);
    if (type != kJsonChunk) {
        throw GltfError("its first GLB chunk is not JSON; re-export it");
    }
    while (!rest.empty() && !out.binary) {
        const Bytes chunk = next_chunk(rest, type);
        if (type == kBinaryChunk) {
            out.binary = chunk;
        }
    }
}

}  // namespace

Container read_container(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = in ? static_cast<std::streamoff>(in.tellg()) : -1;
    if (size < 0) {
        throw GltfError("it cannot be read");
    }
    Container out;
    const auto count = static_cast<std::size_t>(size);
    out.file = std::make_unique_for_overwrite<std::uint8_t[]>(count);
    in.seekg(0);
    if (!in.read(reinterpret_cast<char*>(out.file.get()), size)) {
        throw GltfError("it cannot be read to its end");
    }
    const Bytes file(out.file.get(), count);
    if (count >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), file.begin())) {
        split_glb(file, out);
    } else {
        out.json = file;
    }
    return out;
}

}  // namespace campuswalk::scene::gltf
