#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "collision/base/storage.h"
#include "scene/import/helper/helper_exchange.h"
#include "scene/import/helper/sandbox.h"

namespace campuswalk::scene {

inline constexpr const char* kImageHelperArgument = "image-helper";

/// In pixels, as a file says.
struct ImageSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    std::uint64_t pixels() const { return std::uint64_t{width} * height; }
};

/// The size that a PNG file begins with; nullopt for other files. Nothing is decoded for it.
std::optional<ImageSize> png_size(std::string_view file);

/// 8-bit RGBA, top row first.
struct ForeignImage {
    ImageSize size;
    collision::Storage<std::uint8_t> rgba;  ///< 4 bytes a pixel
    std::string fault;                      ///< why there are no pixels; empty if there are
};

/// Decodes PNG files in one child process that can do nothing else, a program that calls serve_images:
/// whatever they contain, it comes to nothing worse than a fault. A process that crashes or exceeds a limit
/// is a fault of all of them. Throws std::runtime_error if it can't be started.
std::vector<ForeignImage> decode_in_process(const HelperProgram& helper,
                                            std::span<const std::string_view> files, SandboxMode sandbox);

/// Answers one request, from standard input; returns the exit code.
int serve_images();

}  // namespace campuswalk::scene
