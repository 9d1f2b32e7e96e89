#include "scene/osm/objects/step_ramps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kRampLook = {{158, 156, 150}, 230, 255};

/// A kind of ramp.
struct RampKind {
    const char* key;
    double width;  ///< metres
    bool gentle;   ///< longer than the flight, if need be
};

constexpr std::array<RampKind, 3> kRamps = {
    {{"ramp:wheelchair", 1.2, true}, {"ramp:stroller", 0.9, false}, {"ramp:bicycle", 0.4, false}}};
constexpr RampKind kAnyRamp = {"ramp", 1.2, true};

bool has_ramp(const Tags& tags, const char* key) {
    return affirmed(tags, key) && !tags.is(key, "separate") && !tags.is(key, "automatic");
}

/// A ramp's middle line from its top, and the direction to its left, half a width long, at each point.
struct RampLine {
    std::vector<Point> points;
    std::vector<Point> left;

    double length() const {
        double length = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            length += (points[i] - points[i - 1]).norm();
        }
        return length;
    }
};

/// Beside the flight, from its top to its foot; `offset` is that of the middle from the flight's edge.
RampLine beside(const FlightShape& shape, double side, double offset, double width) {
    RampLine line;
    for (auto station = shape.stations.rbegin(); station != shape.stations.rend(); ++station) {
        const Point out = side * unit(station->left);
        line.points.push_back(station->at + side * station->left + offset * out);
        line.left.push_back(0.5 * width * unit(station->left));
    }
    return line;
}

/// Goes on straight beyond the foot while there is room.
void extend(RampLine& line, double length, double ground, const FreeGround& free, const Site& site) {
    constexpr double kStep = 0.5;    // metres
    constexpr double kUneven = 0.5;  // metres that the ground there may differ from that at the foot
    const Point end = line.points.back();
    const Point left = line.left.back();
    const Point along = Point(unit(left).y(), -unit(left).x()) * -1.0;  // away from the top
    const auto usable = [&](const Point& p) {
        return site.map.box.contains(p) && std::abs(site.terrain.height(p) - ground) < kUneven &&
               free.at(p + left) && free.at(p - left);
    };
    double done = 0.0;
    while (done + kStep < length && usable(end + (done + 2.0 * kStep) * along)) {
        done += kStep;
        line.points.push_back(end + done * along);
        line.left.push_back(left);
    }
}

/// Cut so fine that its top follows the ground where that is higher.
void add_strip(const RampLine& line, double top, const Terrain& terrain, ObjectMesh& mesh) {
    constexpr double kAbove = 0.03;  // metres
    constexpr double kBelow = 0.4;
    const double length = line.length();
    const double foot = terrain.height(line.points.back());
    double done = 0.0;
    std::vector<double> heights;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        done += i > 0 ? (line.points[i] - line.points[i - 1]).norm() : 0.0;
        const Point& p = line.points[i];
        heights.push_back(std::max({top + (foot - top) * done / length, terrain.height(p),
                                    terrain.height(p + line.left[i]), terrain.height(p - line.left[i])}) +
                          (i + 1 == line.points.size() ? 0.0 : kAbove));
    }
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const Point la = line.points[i - 1] + line.left[i - 1];
        const Point ra = line.points[i - 1] - line.left[i - 1];
        const Point lb = line.points[i] + line.left[i];
        const Point rb = line.points[i] - line.left[i];
        const double a = heights[i - 1];
        const double b = heights[i];
        const double bottom =
            std::min({terrain.height(la), terrain.height(ra), terrain.height(lb), terrain.height(rb), foot}) -
            kBelow;
        mesh.quad(kRampLook, {la, a}, {lb, b}, {rb, b}, {ra, a});
        mesh.quad(kRampLook, {lb, bottom}, {lb, b}, {la, a}, {la, bottom});
        mesh.quad(kRampLook, {ra, bottom}, {ra, a}, {rb, b}, {rb, bottom});
    }
}

}  // namespace

void add_step_ramps(const Path& path, const FlightShape& shape, const FreeGround& free, const Site& site,
                    ModelBuilder& model) {
    constexpr double kGentleRun = 12.0;  // metres of run for each of rise
    constexpr double kSteepest = 6.0;
    const Tags& tags = path.way->tags;
    std::vector<RampKind> kinds;
    std::ranges::copy_if(kRamps, std::back_inserter(kinds),
                         [&](const RampKind& kind) { return has_ramp(tags, kind.key); });
    if (kinds.empty() && has_ramp(tags, kAnyRamp.key)) {
        kinds.push_back(kAnyRamp);
    }
    const double rise = shape.top - shape.foot;
    double taken = 0.0;
    for (const RampKind& kind : kinds) {
        // From a bridge, within the flight's width.
        const double offset = path.hangs() ? -taken - 0.5 * kind.width : taken + 0.5 * kind.width;
        const double right = shape.reversed ? 1.0 : -1.0;  // as drawn
        RampLine line = beside(shape, right, offset, kind.width);
        if (kind.gentle && !path.hangs()) {
            extend(line, kGentleRun * rise - line.length(), shape.foot, free, site);
        }
        if (kind.gentle && line.length() < kSteepest * rise) {
            site.warn("steep-ramp", "way " + std::to_string(path.way->id) + " has " + kind.key +
                                        ", but there is no room for one that isn't steep");
        }
        add_strip(line, shape.top, site.terrain,
                  model.object("ramp/" + ElementId{ElementKind::way, path.way->id}.text()));
        taken += kind.width;
    }
}

}  // namespace campuswalk::scene::osm
