#include "scene/osm/buildings/roofs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "collision/geometry/trigonometry.h"
#include "scene/osm/geometry/convex_cut.h"

namespace campuswalk::scene::osm {
namespace {

struct NamedShape {
    std::string_view name;
    RoofShape shape;
};

constexpr std::array<NamedShape, 18> kShapes = {{{"flat", RoofShape::flat},
                                                 {"gabled", RoofShape::gabled},
                                                 {"pitched", RoofShape::gabled},
                                                 {"saltbox", RoofShape::gabled},
                                                 {"hipped", RoofShape::hipped},
                                                 {"half-hipped", RoofShape::half_hipped},
                                                 {"half_hipped", RoofShape::half_hipped},
                                                 {"pyramidal", RoofShape::pyramidal},
                                                 {"cone", RoofShape::pyramidal},
                                                 {"skillion", RoofShape::skillion},
                                                 {"lean_to", RoofShape::skillion},
                                                 {"gambrel", RoofShape::gambrel},
                                                 {"mansard", RoofShape::mansard},
                                                 {"dome", RoofShape::dome},
                                                 {"onion", RoofShape::onion},
                                                 {"round", RoofShape::round},
                                                 {"barrel", RoofShape::round},
                                                 {"arched", RoofShape::round}}};

/// Pairs of numbers from 0 to 1, except for an onion's; what they are depends on the roof's family. The
/// highest is 1, as a roof reaches its height.
using Profile = std::vector<std::pair<double, double>>;

enum class RoofFamily {
    flat,
    skillion,
    ridge,  ///< its profile: height by the distance from the eaves, of 1 at the ridge
    rings   ///< its profile: radius, of the footprint's, and height, from the eaves to the top
};

/// What a shape is built from.
struct RoofForm {
    RoofFamily family = RoofFamily::ridge;
    Profile profile = {{0.0, 0.0}, {1.0, 1.0}};
    std::optional<double> hips = {};  ///< the height at which they begin, of the ridge's; none: gables
    double usual_height = 0.6;        ///< of half of the span
    double most_usual = 6.0;          ///< metres
};

/// A quarter of a circle as pairs of its sine and cosine.
Profile arc(int steps) {
    Profile points;
    for (int i = 0; i <= steps; ++i) {
        const collision::SinCos angle = collision::sin_cos(0.5 * std::numbers::pi * i / steps);
        points.emplace_back(angle.sin, angle.cos);
    }
    return points;
}

RoofForm round_roof() {
    RoofForm form{.profile = arc(6)};
    for (auto& [distance, height] : form.profile) {
        height = std::exchange(distance, 1.0 - height);
    }
    return form;
}

RoofForm dome() {
    RoofForm form{RoofFamily::rings, arc(7), {}, 1.0, 1e300};
    for (auto& [radius, height] : form.profile) {
        std::swap(radius, height);
    }
    form.profile.back() = {0.0, 1.0};
    return form;
}

/// A shape that is missing here doesn't compile.
RoofForm form_of(RoofShape shape) {
    switch (shape) {
        case RoofShape::flat:
            return {.family = RoofFamily::flat};
        case RoofShape::gabled:
            return {};
        case RoofShape::hipped:
            return {.hips = 0.0};
        case RoofShape::half_hipped:
            return {.hips = 0.5};
        case RoofShape::pyramidal:
            return {.family = RoofFamily::rings, .profile = {{1.0, 0.0}, {0.0, 1.0}}};
        case RoofShape::skillion:
            return {.family = RoofFamily::skillion};
        case RoofShape::gambrel:
            return {.profile = {{0.0, 0.0}, {0.4, 0.65}, {1.0, 1.0}}};
        case RoofShape::mansard:
            return {.profile = {{0.0, 0.0}, {0.3, 0.75}, {1.0, 1.0}}, .hips = 0.0};
        case RoofShape::dome:
            return dome();
        case RoofShape::onion:
            return {RoofFamily::rings,
                    {{1.0, 0.0},
                     {1.1, 0.1},
                     {1.12, 0.2},
                     {1.0, 0.32},
                     {0.72, 0.44},
                     {0.42, 0.56},
                     {0.2, 0.7},
                     {0.08, 0.85},
                     {0.0, 1.0}},
                    {},
                    2.5,
                    1e300};
        case RoofShape::round:
            return round_roof();
    }
    throw std::logic_error("no shape of a roof");
}

double dot(const Point& a, const Point& b) {
    return a.x() * b.x() + a.y() * b.y();
}

/// The frame of a roof with a ridge: coordinates along it and across it from the middle, in metres.
struct RidgeFrame {
    Point middle = Point::Zero();
    Point along = Point(1, 0);
    Point across = Point(0, 1);
    double half_length = 0.0;
    double half_span = 0.0;

    double u(const Point& p) const { return dot(p - middle, along); }
    double v(const Point& p) const { return dot(p - middle, across); }
    /// The line where `a·u + b·v = c`.
    PlanLine line(double a, double b, double c) const {
        const Point normal = a * along + b * across;
        return {normal, c + dot(normal, middle)};
    }
};

RidgeFrame frame_of(const Polygons& footprint, const Roof& roof, const PlanGeometry& geometry) {
    RidgeFrame frame;
    const Ring rectangle = geometry.least_rectangle(footprint.front().outer);
    if (rectangle.empty()) {
        return frame;
    }
    frame.middle = 0.5 * (rectangle[0] + rectangle[2]);
    const Point longer = rectangle[1] - rectangle[0];
    const Point shorter = rectangle[2] - rectangle[1];
    const double length = std::sqrt(dot(longer, longer));
    const double width = std::sqrt(dot(shorter, shorter));
    frame.along = longer / length;
    frame.across = shorter / width;
    frame.half_length = 0.5 * length;
    frame.half_span = 0.5 * width;
    const bool turn = roof.directed
                          ? std::abs(dot(roof.down, frame.along)) > std::abs(dot(roof.down, frame.across))
                          : roof.across;
    if (turn) {
        frame = {frame.middle, frame.across, -frame.along, frame.half_span, frame.half_length};
    }
    if (roof.directed && dot(roof.down, frame.across) < 0.0) {
        frame.along = -frame.along;
        frame.across = -frame.across;
    }
    return frame;
}

double height_on(const Profile& profile, double distance) {
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const auto& [d0, h0] = profile[i - 1];
        const auto& [d1, h1] = profile[i];
        if (distance <= d1) {
            return h0 + (h1 - h0) * std::max(0.0, distance - d0) / (d1 - d0);
        }
    }
    return profile.back().second;
}

/// A roof that is a function of the plan: its height, and the lines where its slope changes.
class RidgeRoof {
public:
    RidgeRoof(const RidgeFrame& frame, const Roof& roof)
        : frame_(frame), height_(roof.height), form_(form_of(roof.shape)) {
        add_creases();
    }

    double height(const Point& p) const {
        const double v = frame_.v(p) / frame_.half_span;
        if (form_.family == RoofFamily::skillion) {
            return height_ * std::clamp(0.5 * (1.0 - v), 0.0, 1.0);
        }
        double distance = std::max(0.0, 1.0 - std::abs(v));
        if (form_.hips) {
            const double from_end =
                std::max(0.0, (frame_.half_length - std::abs(frame_.u(p))) / frame_.half_span);
            distance = std::min(distance, *form_.hips + from_end);
        }
        return height_ * height_on(form_.profile, distance);
    }

    const std::vector<PlanLine>& creases() const { return creases_; }

private:
    void add_creases() {
        if (form_.family == RoofFamily::skillion) {
            return;
        }
        const double half_span = frame_.half_span;
        creases_.push_back(frame_.line(0, 1, 0));
        for (std::size_t i = 1; i + 1 < form_.profile.size(); ++i) {
            const double v = (1.0 - form_.profile[i].first) * half_span;
            creases_.push_back(frame_.line(0, 1, v));
            creases_.push_back(frame_.line(0, 1, -v));
            if (form_.hips) {
                const double u = frame_.half_length - (form_.profile[i].first - *form_.hips) * half_span;
                creases_.push_back(frame_.line(1, 0, u));
                creases_.push_back(frame_.line(1, 0, -u));
            }
        }
        if (!form_.hips) {
            return;
        }
        // Where the distance from an end equals that from a side: |u| - |v| is constant.
        const double offset = frame_.half_length - half_span + *form_.hips * half_span;
        for (const double side : {1.0, -1.0}) {
            for (const double end : {1.0, -1.0}) {
                creases_.push_back(frame_.line(end, -side, offset));
            }
        }
        creases_.push_back(frame_.line(1, 0, 0));
    }

    RidgeFrame frame_;
    double height_;
    RoofForm form_;
    std::vector<PlanLine> creases_;
};

void add_ridge_roof(const Polygons& footprint, const RidgeRoof& roof, double eaves, const Look& roof_look,
                    const Look& wall_look, const PlanGeometry& geometry, ObjectMesh& mesh) {
    const auto on_roof = [&](const Point& p) { return Point3{p, eaves + roof.height(p)}; };
    for (const Polygon& polygon : footprint) {
        const Triangulation flat = geometry.triangulated(polygon);
        for (const auto& [a, b, c] : flat.triangles) {
            for (const Convex& piece :
                 cut_all({flat.points[a], flat.points[b], flat.points[c]}, roof.creases())) {
                for (std::size_t i = 2; i < piece.size(); ++i) {
                    mesh.triangle(roof_look, on_roof(piece[0]), on_roof(piece[i - 1]), on_roof(piece[i]));
                }
            }
        }
        const auto add_gables = [&](const Ring& ring) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const std::vector<Point> points =
                    cut_segment(ring[i], ring[(i + 1) % ring.size()], roof.creases());
                for (std::size_t k = 1; k < points.size(); ++k) {
                    mesh.quad(wall_look, {points[k - 1], eaves}, {points[k], eaves}, on_roof(points[k]),
                              on_roof(points[k - 1]));
                }
            }
        };
        add_gables(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            add_gables(hole);
        }
    }
}

Point centroid(const Ring& ring) {
    Point sum = Point::Zero();
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i] - ring[0];
        const Point b = ring[(i + 1) % ring.size()] - ring[0];
        const double cross = a.x() * b.y() - a.y() * b.x();
        sum += cross * (a + b);
        twice += cross;
    }
    return ring[0] + sum / (3.0 * twice);
}

void add_ring_roof(const Polygons& footprint, const Roof& roof, double eaves, const Look& look,
                   ObjectMesh& mesh) {
    const Profile rings = form_of(roof.shape).profile;
    for (const Polygon& polygon : footprint) {
        const Point middle = centroid(polygon.outer);
        for (std::size_t k = 1; k < rings.size(); ++k) {
            const auto& [r0, h0] = rings[k - 1];
            const auto& [r1, h1] = rings[k];
            for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
                const Point a = polygon.outer[i] - middle;
                const Point b = polygon.outer[(i + 1) % polygon.outer.size()] - middle;
                const double low = eaves + h0 * roof.height;
                const double high = eaves + h1 * roof.height;
                mesh.quad(look, {middle + r0 * a, low}, {middle + r0 * b, low}, {middle + r1 * b, high},
                          {middle + r1 * a, high});
            }
        }
    }
}

}  // namespace

std::optional<RoofShape> roof_shape(std::string_view word) {
    const auto* found = std::ranges::find(kShapes, word, &NamedShape::name);
    return found == kShapes.end() ? std::nullopt : std::optional(found->shape);
}

bool allows(const Polygons& footprint, RoofShape shape, const PlanGeometry& geometry) {
    if (shape == RoofShape::flat) {
        return true;
    }
    if (footprint.size() != 1 || !footprint.front().holes.empty()) {
        return false;
    }
    const Ring& ring = footprint.front().outer;
    if (form_of(shape).family == RoofFamily::rings) {
        const Point middle = centroid(ring);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i] - middle;
            const Point b = ring[(i + 1) % ring.size()] - middle;
            if (a.x() * b.y() - a.y() * b.x() <= 0.0) {
                return false;
            }
        }
        return true;
    }
    constexpr double kLeastFill = 0.7;
    const Ring rectangle = geometry.least_rectangle(ring);
    return !rectangle.empty() && signed_area(ring) >= kLeastFill * signed_area(rectangle);
}

double usual_height(RoofShape shape, double half_span) {
    const RoofForm form = form_of(shape);
    return std::min(form.usual_height * half_span, form.most_usual);
}

double half_span(const Polygons& footprint, const Roof& roof, const PlanGeometry& geometry) {
    return frame_of(footprint, roof, geometry).half_span;
}

void add_roof(const Polygons& footprint, const Roof& roof, double eaves, const Look& roof_look,
              const Look& wall_look, const PlanGeometry& geometry, ObjectMesh& mesh) {
    if (roof.shape == RoofShape::flat || roof.height <= 0.0) {
        for (const Polygon& polygon : footprint) {
            mesh.level(roof_look, geometry.triangulated(polygon), eaves);
        }
    } else if (form_of(roof.shape).family == RoofFamily::rings) {
        add_ring_roof(footprint, roof, eaves, roof_look, mesh);
    } else {
        add_ridge_roof(footprint, RidgeRoof(frame_of(footprint, roof, geometry), roof), eaves, roof_look,
                       wall_look, geometry, mesh);
    }
}

}  // namespace campuswalk::scene::osm
