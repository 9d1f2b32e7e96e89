#include "scene/osm/objects/steps.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "scene/osm/objects/step_ramps.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/flight_shape.h"
#include "scene/osm/ways/relief.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kTreadLook = {{176, 172, 164}, 230, 255};
constexpr Look kNosing = {{140, 136, 130}, 230, 255};
constexpr Look kRail = {{96, 100, 104}, 140, 255};

void add_treads(const FlightShape& shape, const Terrain& terrain, ObjectMesh& mesh) {
    const std::size_t count = shape.treads();
    const double riser = shape.riser();
    constexpr double kBelow = 0.4;
    for (std::size_t i = 0; i < count; ++i) {
        const Station& a = shape.stations[i];
        const Station& b = shape.stations[i + 1];
        const double height = shape.foot + riser * static_cast<double>(i + 1);
        const double bottom =
            std::min({shape.foot, terrain.height(a.at + a.left), terrain.height(a.at - a.left),
                      terrain.height(b.at + b.left), terrain.height(b.at - b.left)}) -
            kBelow;
        const Point left_a = a.at + a.left;
        const Point right_a = a.at - a.left;
        const Point left_b = b.at + b.left;
        const Point right_b = b.at - b.left;
        mesh.quad(kTreadLook, {right_a, height}, {right_b, height}, {left_b, height}, {left_a, height});
        mesh.wall(kNosing, left_a, right_a, i == 0 ? bottom : height - riser, height);
        mesh.wall(kTreadLook, right_a, right_b, bottom, height);
        mesh.wall(kTreadLook, left_b, left_a, bottom, height);
    }
    const Station& end = shape.stations.back();
    mesh.wall(kTreadLook, end.at - end.left, end.at + end.left, shape.foot - kBelow, shape.top);
    if (shape.beyond) {  // no gap between the highest tread, which is straight, and the deck's edge
        constexpr double kLower = 0.12;
        const Station& b = *shape.beyond;
        const double height = shape.top - kLower;
        mesh.quad(kTreadLook, {end.at - end.left, height}, {b.at - b.left, height}, {b.at + b.left, height},
                  {end.at + end.left, height});
    }
}

/// A rail on posts along the edge on the left (side 1) or right (-1), or along the middle (0).
void add_rail(const FlightShape& shape, double side, ObjectMesh& mesh) {
    const double inset = side == 0.0 ? 0.0 : 0.06;
    constexpr double kPost = 0.025;
    constexpr double kHeight = 0.9;
    const auto place = [&](const Station& station) {
        const Point out = unit(station.left);
        return Point(station.at + side * (station.left - inset * out));
    };
    const std::size_t count = shape.treads();
    const double riser = shape.riser();
    for (std::size_t i = 0; i < count; ++i) {
        const Point a = place(shape.stations[i]);
        const Point b = place(shape.stations[i + 1]);
        const double low = shape.foot + riser * (static_cast<double>(i) + 0.5) + kHeight;
        const double high = low + riser;
        const Point across = 0.02 * left_of(unit(b - a));
        // Four sides of a bar.
        mesh.quad(kRail, {a - across, low}, {b - across, high}, {b + across, high}, {a + across, low});
        mesh.quad(kRail, {a - across, low - 0.05}, {b - across, high - 0.05}, {b - across, high},
                  {a - across, low});
        mesh.quad(kRail, {b + across, high - 0.05}, {a + across, low - 0.05}, {a + across, low},
                  {b + across, high});
        mesh.quad(kRail, {a + across, low - 0.05}, {b + across, high - 0.05}, {b - across, high - 0.05},
                  {a - across, low - 0.05});
        if (i % 4 == 0) {
            mesh.box(kRail, a, unit(b - a), Point(kPost, kPost), low - kHeight - riser, low);
        }
    }
}

/// Whether it says up or down, or how steep.
bool is_readable_incline(std::string_view incline) {
    return incline.empty() || incline == "up" || incline == "down" || incline == "yes" ||
           slope_of(incline).has_value();
}

/// Warns of tags that the flight doesn't follow.
void report_ignored_tags(const Path& path, const FlightShape& shape, const Site& site) {
    const Tags& tags = path.way->tags;
    const std::string id = ElementId{ElementKind::way, path.way->id}.text();
    const auto count = number_of(tags, "step_count");
    if (count && std::llround(*count) != static_cast<long long>(shape.treads())) {
        site.warn("odd-steps", id + " has step_count=" + std::string(tags.get("step_count")) +
                                   " and climbs " +
                                   std::to_string(std::lround(100.0 * (shape.top - shape.foot))) +
                                   " cm; it has " + std::to_string(shape.treads()) + " treads");
    }
    if (!is_readable_incline(tags.get("incline"))) {
        site.warn("odd-steps", id + ": incline=" + std::string(tags.get("incline")) +
                                   " is ignored; write up, down, 30% or 17\u00B0");
    }
}

}  // namespace

Built add_steps(const Site& site, const Built& before, ModelBuilder& model) {
    const FreeGround free(site, before);
    Built built;
    for (const Path& path : site.paths) {
        if (!has_treads(path, site.terrain)) {
            continue;
        }
        const FlightShape shape = shape_of(path, site.terrain);
        const std::string id = ElementId{ElementKind::way, path.way->id}.text();
        ObjectMesh& mesh = model.object("steps/" + id);
        add_treads(shape, site.terrain, mesh);
        report_ignored_tags(path, shape, site);
        const Tags& tags = path.way->tags;
        const bool both = affirmed(tags, "handrail") || affirmed(tags, "handrail:both");
        const double left = shape.reversed ? -1.0 : 1.0;  // tags mean the direction as drawn
        if (both || affirmed(tags, "handrail:left")) {
            add_rail(shape, left, mesh);
        }
        if (both || affirmed(tags, "handrail:right")) {
            add_rail(shape, -left, mesh);
        }
        if (affirmed(tags, "handrail:center")) {
            add_rail(shape, 0.0, mesh);
        }
        built.flights.push_back(site.geometry.polygon(outline_of_treads(path, site.terrain)));
        add_step_ramps(path, shape, free, site, model);
    }
    built.solids.push_back({"ramp", {"ramp/*"}, "", "ramp", true});  // left out if there is none
    return built;
}

}  // namespace campuswalk::scene::osm
