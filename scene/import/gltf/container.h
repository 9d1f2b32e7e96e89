#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>

namespace campuswalk::scene::gltf {

using Bytes = std::span<const std::uint8_t>;

/// An error in a glTF file; GltfSource turns it into InputError.
class GltfError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A `.gltf` or `.glb` file split into its chunks. The magic bytes tell which it is, not the name.
struct Container {
    std::unique_ptr<std::uint8_t[]> file;  ///< backs the spans
    Bytes json;
    std::optional<Bytes> binary;  ///< a GLB's BIN chunk
};

/// Throws GltfError if the file can't be read, is truncated, or is a GLB of another version than 2.
Container read_container(const std::filesystem::path& path);

}  // namespace campuswalk::scene::gltf
