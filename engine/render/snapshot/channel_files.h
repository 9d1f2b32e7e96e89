#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/render/image/channels.h"
#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// The channels to draw for the requested files.
ChannelChoice choice_of(const ImageChannels& channels);

/// The suffixes of the files, appended to the image's name without extension: "-depth.png", "-ids.png",
/// "-ids.json",
/// "-normals.png".
std::vector<std::string> channel_endings(const ImageChannels& channels);

/// Converts metres to millimetres, clamped to 1 to 65535; 0 stays 0 (background).
std::vector<std::uint16_t> millimetres(const std::vector<float>& metres);

/// A colour for an id, unique for the first 2^24; black for 0.
std::array<std::uint8_t, 3> id_color(std::uint32_t id);

/// Writes the channels in `requested` to `base` + suffix:
///   -depth.png    16-bit greyscale, millimetres along the camera axis
///   -ids.png      id_color of each pixel's id
///   -ids.json     for each id in the image: color, pixels, and its building and object, if any
///   -normals.png  as in Channels
/// Returns the paths. Throws std::runtime_error that names a file that can't be written.
std::vector<std::filesystem::path> write_channels(SnapshotRenderer& renderer, const scene::Campus& campus,
                                                  const Channels& channels, const ImageChannels& requested,
                                                  const std::filesystem::path& base);

}  // namespace campuswalk::engine::render
