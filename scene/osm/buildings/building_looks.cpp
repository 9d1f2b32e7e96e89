#include "scene/osm/buildings/building_looks.h"

#include <array>
#include <string>
#include <string_view>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr std::array<Color, 6> kPlaster = {
    {{226, 216, 196}, {214, 206, 190}, {204, 190, 166}, {220, 204, 176}, {198, 196, 190}, {208, 184, 160}}};
constexpr std::array<Color, 4> kBrick = {{{160, 92, 72}, {172, 108, 84}, {146, 84, 68}, {182, 130, 104}}};
constexpr std::array<Color, 3> kTiles = {{{150, 80, 62}, {138, 76, 60}, {122, 74, 64}}};

template <std::size_t Count>
Color chosen(const std::array<Color, Count>& colors, const ElementId& id) {
    // Spread over the numbers, which are dense.
    const auto number = static_cast<std::uint64_t>(id.number) * 0x9E3779B97F4A7C15ULL;
    return colors[(number >> 32U) % Count];
}

/// As "building:material" and, with more weight, "building:colour" say; likewise of the roof.
void color_by_tags(const Tags& tags, const std::string& part, Look& look) {
    if (const auto material = material_color(tags.get(part + ":material"))) {
        look.color = *material;
    }
    if (const auto color = color_of(tags, part + ":colour", part + ":color")) {
        look.color = *color;
    }
}

}  // namespace

Look wall_look(const Volume& volume) {
    const std::string_view kind = building_kind(volume.tags);
    Look look{chosen(kPlaster, volume.id), 235, 255};
    if (kind == "house" || kind == "school" || kind == "dormitory" || kind == "industrial") {
        look.color = chosen(kBrick, volume.id);
    } else if (kind == "garage" || kind == "garages" || kind == "service" || kind == "shed") {
        look.color = {170, 166, 158};
    }
    color_by_tags(volume.tags, "building", look);
    return look;
}

Look roof_look(const Volume& volume) {
    Look look{{142, 140, 136}, 240, 255};
    if (volume.roof.shape == RoofShape::dome || volume.roof.shape == RoofShape::onion) {
        look.color = {110, 150, 134};
    } else if (volume.roof.shape != RoofShape::flat) {
        look.color = chosen(kTiles, volume.id);
    }
    color_by_tags(volume.tags, "roof", look);
    return look;
}

bool has_windows(const Volume& volume) {
    const std::string_view kind = building_kind(volume.tags);
    return kind != "garage" && kind != "garages" && kind != "shed" && kind != "service" &&
           kind != "carport" && kind != "roof" && !affirmed(volume.tags, "bridge:support") &&
           !volume.tags.is("building:part", "steps") && !volume.tags.is("window", "no");
}

}  // namespace campuswalk::scene::osm
