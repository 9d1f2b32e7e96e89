#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace campuswalk::scene::gltf {

using Bytes = std::span<const std::uint8_t>;

/// A `.gltf` or `.glb` file taken apart. Which of the two it is, its first bytes say, not its name.
struct Container {
    std::unique_ptr<std::uint8_t[]> file;  ///< what the others point into
    Bytes json;
    std::optional<Bytes> binary;  ///< a GLB's BIN chunk
};

/// Throws Fault when the file can't be read, ends early or is no GLB of version 2.
Container read_container(const std::filesystem::path& path);

}  // namespace campuswalk::scene::gltf
