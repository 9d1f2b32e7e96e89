#include "scene/osm/ways/sidewalks.h"

#include <algorithm>
#include <optional>
#include <string>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kSlabs = {{176, 170, 160}, 235, 255};
constexpr double kUsualWidth = 1.8;  // metres

bool is_there(std::string_view value) {
    return value == "yes";  // "separate" is a path of its own
}

/// The width of the sidewalk on a side, "left" or "right"; nullopt if there is none.
std::optional<double> width_on(const Tags& tags, const std::string& side) {
    const std::string_view value = tags.get("sidewalk");
    const bool there = value == side || value == "both" || value == "yes" ||
                       is_there(tags.get("sidewalk:" + side)) || is_there(tags.get("sidewalk:both"));
    if (!there || tags.is("sidewalk:" + side, "no") || tags.is("sidewalk:" + side, "separate")) {
        return std::nullopt;
    }
    for (const std::string& key :
         {"sidewalk:" + side + ":width", std::string("sidewalk:both:width"), std::string("sidewalk:width")}) {
        if (const auto width = length_of(tags, key)) {
            return std::clamp(*width, 0.5, 20.0);
        }
    }
    return kUsualWidth;
}

}  // namespace

std::vector<Surface> sidewalks_of(const std::vector<Path>& paths, const PlanGeometry& geometry) {
    constexpr int kPriority = 81;  // above paths, below what they lead to
    std::vector<Surface> sidewalks;
    for (const Path& path : paths) {
        if (!path.carriageway || !path.on_ground()) {
            continue;
        }
        for (const char* side : {"left", "right"}) {
            const auto width = width_on(path.way->tags, side);
            if (!width) {
                continue;
            }
            std::vector<Point> line = path.way->points;
            if (*side == 'r') {
                std::ranges::reverse(line);
            }
            sidewalks.push_back({"sidewalk/" + ElementId{ElementKind::way, path.way->id}.text(),
                                 geometry.left_side(line, 0.5 * path.width + *width), kSlabs, kPriority});
        }
    }
    return sidewalks;
}

}  // namespace campuswalk::scene::osm
