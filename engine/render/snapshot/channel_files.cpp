#include "engine/render/snapshot/channel_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

#include <nlohmann/json.hpp>

#include "engine/render/image/depth_png.h"
#include "engine/render/image/png.h"
#include "scene/base/atomic_file.h"

namespace campuswalk::engine::render {
namespace {

// Odd, so that no two numbers below 2^24 give the same colour; near the golden ratio, so that neighbours
// differ much.
constexpr std::uint32_t kSpread = 0x9E3779U;

std::string hex_of(const std::array<std::uint8_t, 3>& color) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color[0], color[1], color[2]);
    return text.data();
}

Image colored(const IdImage& ids) {
    Image image{ids.width, ids.height, {}};
    image.rgba.reserve(4 * ids.ids.size());
    for (const std::uint32_t id : ids.ids) {
        const std::array<std::uint8_t, 3> color = id_color(id);
        image.rgba.insert(image.rgba.end(), {color[0], color[1], color[2], 255});
    }
    return image;
}

std::string names_json(const scene::Campus& campus, const IdImage& ids) {
    std::vector<std::size_t> pixels(ids.names.size(), 0);
    for (const std::uint32_t id : ids.ids) {
        ++pixels[id];
    }
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::uint32_t id = 0; id < pixels.size(); ++id) {
        if (pixels[id] == 0) {
            continue;
        }
        nlohmann::ordered_json entry;
        entry["id"] = id;
        entry["color"] = hex_of(id_color(id));
        entry["pixels"] = pixels[id];
        const PixelOwner& name = ids.names[id];
        if (name.building) {
            entry["building"] = campus.description.buildings[*name.building].id;
        }
        if (name.object) {
            entry["object"] = campus.objects[*name.object].id;
        }
        list.push_back(std::move(entry));
    }
    nlohmann::ordered_json json;
    json["width"] = ids.width;
    json["height"] = ids.height;
    json["ids"] = std::move(list);
    return json.dump(2) + '\n';
}

}  // namespace

ChannelChoice choice_of(const ImageChannels& channels) {
    return {.nodes = channels.ids, .depth = channels.depth, .normals = channels.normals};
}

std::vector<std::string> channel_endings(const ImageChannels& channels) {
    std::vector<std::string> endings;
    if (channels.depth) {
        endings.emplace_back("-depth.png");
    }
    if (channels.ids) {
        endings.emplace_back("-ids.png");
        endings.emplace_back("-ids.json");
    }
    if (channels.normals) {
        endings.emplace_back("-normals.png");
    }
    return endings;
}

std::vector<std::uint16_t> millimetres(const std::vector<float>& metres) {
    std::vector<std::uint16_t> all;
    all.reserve(metres.size());
    for (const float depth : metres) {
        const float rounded = std::round(1000.0F * depth);
        all.push_back(depth <= 0.0F ? std::uint16_t{0}
                                    : static_cast<std::uint16_t>(std::clamp(rounded, 1.0F, 65535.0F)));
    }
    return all;
}

std::array<std::uint8_t, 3> id_color(std::uint32_t id) {
    const std::uint32_t color = id * kSpread;
    return {static_cast<std::uint8_t>((color >> 16U) & 255U), static_cast<std::uint8_t>((color >> 8U) & 255U),
            static_cast<std::uint8_t>(color & 255U)};
}

std::vector<std::filesystem::path> write_channels(SnapshotRenderer& snapshot_renderer,
                                                  const scene::Campus& campus, const Channels& channels,
                                                  const ImageChannels& wanted,
                                                  const std::filesystem::path& base) {
    std::vector<std::filesystem::path> files;
    for (const std::string& ending : channel_endings(wanted)) {
        files.emplace_back(base.string() + ending);
    }
    auto file = files.begin();
    if (wanted.depth) {
        const auto png = encode_depth_png(channels.width, channels.height, millimetres(channels.depth));
        scene::write_file_atomically(*file++, std::as_bytes(std::span(png)));
    }
    if (wanted.ids) {
        const IdImage ids = snapshot_renderer.ids_of(channels);
        write_png(colored(ids), *file++);
        scene::write_file_atomically(*file++, names_json(campus, ids));
    }
    if (wanted.normals) {
        write_png(channels.normals, *file++);
    }
    return files;
}

}  // namespace campuswalk::engine::render
