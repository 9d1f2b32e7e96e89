#include "scene/osm/bridges/deck_parts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace campuswalk::scene::osm {
namespace {

constexpr double kSlope = 0.16;  // of what leads down from a deck

double length_between(const Point& a, const Point& b) {
    const Point d = b - a;
    return norm(d);
}

/// The line of a path from one of its nodes, forwards or backwards; of one point at its end.
std::vector<Point> line_from(const Path& path, std::size_t place, bool forwards) {
    const std::vector<Point>& points = path.way->points;
    const auto at = points.begin() + static_cast<std::ptrdiff_t>(place);
    std::vector<Point> line =
        forwards ? std::vector<Point>(at, points.end()) : std::vector<Point>(points.begin(), at + 1);
    if (!forwards) {
        std::reverse(line.begin(), line.end());
    }
    return line;
}

/// What leads down from an open end along a path, as far as the ground is lower.
DeckPart ramp_along(const Path& path, const std::vector<Point>& line, double height, const Terrain& terrain) {
    constexpr double kStep = 0.5;  // metres
    DeckPart ramp{&path, {}, {}, path.width, {}};
    ramp.line.push_back(line.front());
    ramp.heights.push_back(height);
    double done = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double length = length_between(line[i - 1], line[i]);
        const int samples = std::clamp(static_cast<int>(std::ceil(length / kStep)), 1, 1000);
        for (int k = 1; k <= samples; ++k) {
            const Point p = line[i - 1] + (line[i] - line[i - 1]) * (static_cast<double>(k) / samples);
            const double z = height - kSlope * (done + length * k / samples);
            const bool last = k == samples || terrain.height(p) >= z;
            if (last) {
                ramp.line.push_back(p);
                ramp.heights.push_back(std::max(z, terrain.height(p)));
            }
            if (terrain.height(p) >= z) {
                return ramp;
            }
        }
        done += length;
    }
    return ramp;
}

/// How far a line runs inside an area from its start, metres.
double length_from_start_inside(const std::vector<Point>& line, const Polygons& area) {
    constexpr double kStep = 0.05;  // metres
    constexpr int kMost = 400;
    double done = 0.0;
    double inside = 0.0;
    for (std::size_t i = 1; i < line.size() && done < kStep * kMost; ++i) {
        const double length = length_between(line[i - 1], line[i]);
        const int samples = std::clamp(static_cast<int>(length / kStep), 1, kMost);
        for (int k = 1; k <= samples; ++k) {
            const Point p = line[i - 1] + (line[i] - line[i - 1]) * (static_cast<double>(k) / samples);
            if (!contains(area, p)) {
                return inside;
            }
            inside = done + length * k / samples;
        }
        done += length;
    }
    return inside;
}

/// The paths that lead on from the open ends, as far as the ground is lower.
void add_ramps(const Bridge& bridge, const Site& site, std::vector<DeckPart>& parts) {
    const Terrain& terrain = site.terrain;
    for (const PathAtBridge& on : bridge.leading_on) {
        for (const bool forwards : {true, false}) {
            const Path& path = site.paths[on.path];
            const std::vector<Point> line = line_from(path, on.place, forwards);
            if (line.size() < 2) {
                continue;
            }
            DeckPart ramp = ramp_along(path, line, on.height, terrain);
            constexpr double kLow = 0.05;  // metres: it is on the ground
            if (ramp.line.size() < 2 || on.height - terrain.height(line.front()) < kLow) {
                continue;
            }
            if (ramp.heights.back() - terrain.height(ramp.line.back()) > 0.3) {
                site.warn("steep-bridge", "way " + std::to_string(path.way->id) +
                                              " is too short to lead down from a bridge to the ground");
            }
            ramp.area = site.geometry.buffer(ramp.line, 0.5 * ramp.width, Caps::round);
            parts.push_back(std::move(ramp));
        }
    }
}

/// What an outline has beside all decks, as high as the path of the bridge that runs farthest in it.
DeckPart rest_of_outline(const MapArea& outline, const Bridge& bridge, const Polygons& own,
                         const Site& site) {
    DeckPart rest;
    double farthest = -1.0;
    for (const std::size_t number : bridge.paths) {
        const Path& path = site.paths[number];
        const double inside = length_inside(path.way->points, outline.polygons);
        if (inside > farthest) {
            farthest = inside;
            rest = {&path, path.way->points, path.deck, path.width, {}};
        }
    }
    rest.area = site.geometry.difference(outline.polygons, own);
    for (const Path& path : site.paths) {
        if (path.is_above() && !rest.area.empty()) {
            rest.area = site.geometry.difference(rest.area, path.area);
        }
    }
    return rest;
}

}  // namespace

Deck deck_of(const Bridge& bridge, const Site& site) {
    const PlanGeometry& geometry = site.geometry;
    geometry.charge_to(ElementId{ElementKind::way, site.paths[bridge.paths.front()].way->id}.text());
    std::vector<DeckPart> parts;
    for (const std::size_t number : bridge.paths) {
        const Path& path = site.paths[number];
        parts.push_back({&path, path.way->points, path.deck, path.width, path.area});
    }
    add_ramps(bridge, site, parts);
    Polygons all;
    for (DeckPart& part : parts) {
        const Polygons whole = part.area;
        part.area = all.empty() ? whole : geometry.difference(whole, all);
        all = all.empty() ? whole : geometry.united({&all, &whole});
    }
    for (const std::size_t number : bridge.outlines) {
        parts.push_back(rest_of_outline(site.areas[number], bridge, all, site));
        all = geometry.united({&all, &parts.back().area});
    }
    std::vector<StairsTrim> trims;
    for (const PathAtBridge& stairs : bridge.stairs) {
        const bool first = stairs.place == 0;
        const std::vector<Point> line = line_from(site.paths[stairs.path], stairs.place, first);
        trims.push_back({stairs.path, first, length_from_start_inside(line, all)});
    }
    for (DeckPart& part : parts) {
        part.area = geometry.clipped(part.area, site.ground);
    }
    std::erase_if(parts, [](const DeckPart& part) { return part.area.empty(); });
    return {&bridge, std::move(parts), std::move(trims)};
}

}  // namespace campuswalk::scene::osm
