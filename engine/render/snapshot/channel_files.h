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

/// What must be drawn for the channels that are kept.
ChannelChoice choice_of(const ImageChannels& channels);

/// What is appended to an image's name without its ending: "-depth.png", "-ids.png", "-ids.json",
/// "-normals.png".
std::vector<std::string> channel_endings(const ImageChannels& channels);

/// Millimetres, at most 65535; 0 is nothing, so nearer than half a millimetre is 1.
std::vector<std::uint16_t> millimetres(const std::vector<float>& metres);

/// The colour that stands for an id, different for each of the first 2^24; black for 0.
std::array<std::uint8_t, 3> id_color(std::uint32_t id);

/// Writes what `channels` has and `wanted` asks for to `base` with channel_endings:
///   -depth.png    16-bit grey, millimetres along the camera's axis
///   -ids.png      id_color of each pixel's id
///   -ids.json     for each id in the image: color, pixels, building and object where there are any
///   -normals.png  as Channels has them
/// Returns the files. Throws std::runtime_error that names one that can't be written.
std::vector<std::filesystem::path> write_channels(SnapshotRenderer& snapshot_renderer,
                                                  const scene::Campus& campus, const Channels& channels,
                                                  const ImageChannels& wanted,
                                                  const std::filesystem::path& base);

}  // namespace campuswalk::engine::render
