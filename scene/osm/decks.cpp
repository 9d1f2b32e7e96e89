#include "scene/osm/decks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/osm/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kAbove = 0.02;  // metres that a deck is above the ground beside its ends
constexpr double kSlope = 0.16;  // of what leads down from it
constexpr Look kConcrete = {{170, 168, 162}, 235, 255};
constexpr Look kDeckAsphalt = {{112, 112, 114}, 235, 255};
constexpr Look kParapet = {{120, 126, 126}, 190, 150};
constexpr Look kRail = {{92, 98, 102}, 140, 255};

double length_between(const Point& a, const Point& b) {
    const Point d = b - a;
    return norm(d);
}

double height_at(const DeckPart& part, const Point& p) {
    return height_along(part.line, part.heights, p);
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
double length_inside(const std::vector<Point>& line, const Polygons& area) {
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

Polygons area_of_parts(const std::vector<DeckPart>& parts, const PlanGeometry& geometry) {
    std::vector<const Polygons*> all;
    for (const DeckPart& part : parts) {
        all.push_back(&part.area);
    }
    return geometry.united(all);
}

class DeckBuilder {
public:
    DeckBuilder(const std::vector<DeckPart>& parts, const Bridge& bridge, Composition& composition)
        : parts_(parts),
          bridge_(bridge),
          composition_(composition),
          mesh_(composition.model.object(
              "bridge/" +
              ElementId{ElementKind::way, composition.paths[bridge.paths.front()].way->id}.text())) {
        for (const PathAtBridge& stairs : bridge.stairs) {
            stairs_.push_back(&composition.paths[stairs.path]);
        }
    }

    void add_slab() {
        for (const DeckPart& part : parts_) {
            const Look look = part.path->carriageway ? kDeckAsphalt : look_of_deck(part.path->way->tags);
            for (const Polygon& polygon : part.area) {
                const Triangulation flat = composition_.geometry.triangulated(polygon);
                for (const auto& [a, b, c] : flat.triangles) {
                    const Point3 pa = top(part, flat.points[a]);
                    const Point3 pb = top(part, flat.points[b]);
                    const Point3 pc = top(part, flat.points[c]);
                    mesh_.triangle(look, pa, pb, pc);
                    mesh_.triangle(kConcrete, under(pa), under(pc), under(pb));
                }
            }
        }
    }

    /// The slab's sides and what keeps people from falling, around all parts.
    void add_edges() {
        constexpr double kPiece = 1.5;  // metres
        for (const Polygon& polygon : area_of_parts(parts_, composition_.geometry)) {
            std::vector<const Ring*> rings = {&polygon.outer};
            for (const Ring& hole : polygon.holes) {
                rings.push_back(&hole);
            }
            for (const Ring* ring : rings) {
                for (std::size_t i = 0; i < ring->size(); ++i) {
                    const Point& a = (*ring)[i];
                    const Point& b = (*ring)[(i + 1) % ring->size()];
                    const int pieces = std::clamp(static_cast<int>(length_between(a, b) / kPiece), 1, 1000);
                    for (int k = 0; k < pieces; ++k) {
                        add_edge(a + (b - a) * (static_cast<double>(k) / pieces),
                                 a + (b - a) * ((k + 1.0) / pieces));
                    }
                }
            }
        }
    }

private:
    static Look look_of_deck(const Tags& tags) {
        const std::string_view surface = tags.get("surface");
        if (const auto color = material_color(surface)) {
            return {*color, 220, 255};
        }
        return kConcrete;
    }

    static Point3 top(const DeckPart& part, const Point& p) { return {p, height_at(part, p) + kAbove}; }
    Point3 under(const Point3& p) const { return {p.at, p.height - bridge_.thickness - kAbove}; }

    Point3 top_of_nearest(const Point& p) const {
        const DeckPart* best = &parts_.front();
        double nearest = 1e300;
        for (const DeckPart& part : parts_) {
            const double distance = nearest_on(part.line, false, p).distance - 0.5 * part.width;
            if (distance < nearest) {
                nearest = distance;
                best = &part;
            }
        }
        return top(*best, p);
    }

    void add_edge(const Point& a, const Point& b) {
        const Point3 high_a = top_of_nearest(a);
        const Point3 high_b = top_of_nearest(b);
        mesh_.quad(kConcrete, under(high_a), under(high_b), high_b, high_a);
        const Point out = Point(unit(b - a).y(), -unit(b - a).x());  // rings run around areas on their left
        const Point middle = 0.5 * (a + b);
        constexpr double kFall = 0.45;  // metres that need a parapet
        const double drop =
            0.5 * (high_a.height + high_b.height) - composition_.terrain.height(middle + 0.3 * out);
        if (drop < kFall || leads_to_stairs(middle)) {
            return;
        }
        add_parapet(high_a, high_b, -out);
    }

    /// A panel between posts under a handrail, a little inside of the edge.
    void add_parapet(const Point3& a, const Point3& b, const Point& inwards) {
        constexpr double kHeight = 1.1;
        constexpr double kInset = 0.08;
        constexpr double kHalf = 0.03;
        const Point from = a.at + kInset * inwards;
        const Point to = b.at + kInset * inwards;
        const auto bar = [&](const Look& look, double half, double low, double high) {
            const Point side = half * inwards;
            const auto at = [](const Point& p, double height) { return Point3{p, height}; };
            const double al = a.height + low;
            const double bl = b.height + low;
            const double ah = a.height + high;
            const double bh = b.height + high;
            mesh_.quad(look, at(from - side, al), at(to - side, bl), at(to - side, bh), at(from - side, ah));
            mesh_.quad(look, at(to + side, bl), at(from + side, al), at(from + side, ah), at(to + side, bh));
            mesh_.quad(look, at(from - side, ah), at(to - side, bh), at(to + side, bh), at(from + side, ah));
        };
        bar(kParapet, 0.01, 0.0, kHeight - 0.05);
        bar(kRail, kHalf, kHeight - 0.05, kHeight);
        mesh_.box(kRail, from, unit(b.at - a.at), Point(kHalf, kHalf), a.height, a.height + kHeight);
    }

    bool leads_to_stairs(const Point& p) const {
        return std::ranges::any_of(stairs_, [&](const Path* path) {
            return nearest_on(path->way->points, false, p).distance < 0.5 * path->width + 0.1;
        });
    }

    const std::vector<DeckPart>& parts_;
    const Bridge& bridge_;
    Composition& composition_;
    ObjectMesh& mesh_;
    std::vector<const Path*> stairs_;
};

}  // namespace

std::vector<DeckPart> deck_of(const Bridge& bridge, const PlanGeometry& geometry, const Terrain& terrain,
                              std::vector<Path>& paths, const SourceMark& mark, DiagnosticList& warnings) {
    std::vector<DeckPart> parts;
    for (const std::size_t number : bridge.paths) {
        const Path& path = paths[number];
        parts.push_back({&path, path.way->points, path.deck, path.width, path.area});
    }
    for (const PathAtBridge& on : bridge.leading_on) {
        for (const bool forwards : {true, false}) {
            const Path& path = paths[on.path];
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
                warnings.warning(mark, "steep-bridge",
                                 "way " + std::to_string(path.way->id) +
                                     " is too short to lead down from a bridge to the ground");
            }
            ramp.area = geometry.buffer(ramp.line, 0.5 * ramp.width, Caps::round);
            parts.push_back(std::move(ramp));
        }
    }
    Polygons all;
    for (DeckPart& part : parts) {
        const Polygons whole = part.area;
        part.area = all.empty() ? whole : geometry.difference(whole, all);
        all = all.empty() ? whole : geometry.united({&all, &whole});
    }
    for (const PathAtBridge& stairs : bridge.stairs) {
        Path& path = paths[stairs.path];
        const double trim = length_inside(line_from(path, stairs.place, stairs.place == 0), all);
        (stairs.place == 0 ? path.first_trim : path.last_trim) = trim;
    }
    return parts;
}

void add_deck(const std::vector<DeckPart>& parts, const Bridge& bridge, Composition& composition) {
    DeckBuilder builder(parts, bridge, composition);
    builder.add_slab();
    builder.add_edges();
}

}  // namespace campuswalk::scene::osm
