#include "engine/render/snapshot/channel_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

#include <nlohmann/json.hpp>

#include "engine/render/image/png.h"
#include "scene/base/atomic_file.h"
#include "scene/base/printable.h"

namespace campuswalk::engine::render {
namespace {

// Odd, so that all numbers below 2^24 give different colours; near the golden ratio, so that successive ones
// differ clearly.
constexpr std::uint32_t kMultiplier = 0x9E3779U;

std::string hex_color(const std::array<std::uint8_t, 3>& color) {
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

std::string owners_json(const scene::Campus& campus, const IdImage& ids) {
    std::vector<std::size_t> pixels(ids.owners.size(), 0);
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
        entry["color"] = hex_color(id_color(id));
        entry["pixels"] = pixels[id];
        const PixelOwner& owner = ids.owners[id];
        if (owner.building) {
            entry["building"] = campus.description.buildings[*owner.building].id;
        }
        if (owner.object) {
            entry["object"] = campus.objects[*owner.object].id;
        }
        list.push_back(std::move(entry));
    }
    nlohmann::ordered_json json;
    json["width"] = ids.width;
    json["height"] = ids.height;
    json["ids"] = std::move(list);
    return scene::printable_json(json.dump(2)) + '\n';
}

}  // namespace

ChannelChoice choice_of(const ImageChannels& channels) {
    return {.nodes = channels.ids, .depth = channels.depth, .normals = channels.normals};
}

std::vector<std::string> channel_endings(const ImageChannels& channels) {
    std::vector<std::string> suffixes;
    if (channels.depth) {
        suffixes.emplace_back("-depth.png");
    }
    if (channels.ids) {
        suffixes.emplace_back("-ids.png");
        suffixes.emplace_back("-ids.json");
    }
    if (channels.normals) {
        suffixes.emplace_back("-normals.png");
    }
    return suffixes;
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
    const std::uint32_t color = id * kMultiplier;
    return {static_cast<std::uint8_t>((color >> 16U) & 255U), static_cast<std::uint8_t>((color >> 8U) & 255U),
            static_cast<std::uint8_t>(color & 255U)};
}

std::vector<std::filesystem::path> write_channels(SnapshotRenderer& renderer, const scene::Campus& campus,
                                                  const Channels& channels, const ImageChannels& requested,
                                                  const std::filesystem::path& base) {
    std::vector<std::filesystem::path> files;
    for (const std::string& suffix : channel_endings(requested)) {
        files.emplace_back(base.string() + suffix);
    }
    auto file = files.begin();
    if (requested.depth) {
        const auto png = encode_depth_png(channels.width, channels.height, millimetres(channels.depth));
        scene::write_file_atomically(*file++, std::as_bytes(std::span(png)));
    }
    if (requested.ids) {
        const IdImage ids = renderer.ids_of(channels);
        write_png(colored(ids), *file++);
        scene::write_file_atomically(*file++, owners_json(campus, ids));
    }
    if (requested.normals) {
        write_png(channels.normals, *file++);
    }
    return files;
}

}  // namespace campuswalk::engine::render
