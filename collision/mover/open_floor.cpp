#include "collision/mover/open_floor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <Eigen/Geometry>

#include "collision/mover/sphere_rest.h"

namespace campuswalk::collision {

namespace {

/// The radii of floors that are worth knowing, metres.
constexpr double kLargest = 1.0;
constexpr double kSmallest = 0.08;
/// Of the hash table: a power of two, and the edge length of the cells that share an entry, metres.
constexpr std::size_t kFloors = 64;
constexpr double kCellsPerMetre = 2.0;
/// After a failed attempt, so many moves pass before the next.
constexpr int kPause = 3;

/// What is this much farther than the body's reach doesn't matter to it, metres: more than what the heights
/// of two points may differ by that both carry it (find_ground), far more than rounding.
constexpr double kBeyond = 3e-4;
/// A flush face is farther than that if the body doesn't touch its plane this near, metres.
constexpr double kAside = 0.02;
/// What is no higher than this over a face lies below it, metres.
constexpr double kFlush = 1e-6;
/// A foot this near to its height on a face stands on it, metres.
constexpr double kOnFace = 1e-6;

std::size_t slot_of(const Vec3& place) {
    const auto cell = [](double at) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at * kCellsPerMetre)));
    };
    const std::uint64_t key =
        cell(place.x()) * 0x9e3779b97f4a7c15ULL + cell(place.z()) * 0xc2b2ae3d27d4eb4fULL;
    return static_cast<std::size_t>(key >> 40U) & (kFloors - 1);
}

double squared(double x) {
    return x * x;
}

double horizontal_distance2(const Vec3& a, const Vec3& b) {
    return squared(a.x() - b.x()) + squared(a.z() - b.z());
}

/// How far a point of the triangle's plane is from its border; negative outside.
double depth_inside(const Triangle& t, const Vec3& normal, const Vec3& point) {
    const auto depth = [&](const Vec3& from, const Vec3& to) {
        const Vec3 edge = to - from;
        return normal.dot(edge.cross(point - from)) / edge.norm();
    };
    return std::min({depth(t.a, t.b), depth(t.b, t.c), depth(t.c, t.a)});
}

}  // namespace

/// What there is around a body.
class OpenFloors::Survey {
public:
    Survey(MoveContext& context, const Vec3& foot, double length)
        : context_(context),
          body_(context.body),
          foot_(foot),
          reach_(body_.radius + kRestGap),
          wall_reach_(body_.radius + body_.skin + std::max(length, kListed) + kBeyond) {
        floor_.center = foot;
        floor_.length = length;
    }

    /// None if other things matter so near that it isn't worth knowing.
    std::optional<OpenFloor> find() {
        floor_.radius = std::min(kLargest, room_aside());
        if (floor_.radius < kSmallest || is_too_low(floor_.length) || !find_faces()) {
            return std::nullopt;
        }
        const double slope = horizontal_norm(up()) / up().y();
        if (slope > 0.0) {
            floor_.radius = std::min(floor_.radius, room_above_and_below() / slope);
        }
        const double rise = slope * floor_.radius;
        lowest_ = foot_.y() - rise;
        const double reach = wall_reach_ - body_.radius;
        for (const ContactCache::Index i :
             context_.contacts.survey(foot_, floor_.radius, rise, rise, reach)) {
            if (!is_face(i)) {
                limit_by(i);
            }
            if (floor_.radius < kSmallest) {
                return std::nullopt;
            }
        }
        return floor_;
    }

private:
    /// Up to where the contact cache knows what there is.
    double room_aside() const {
        const Aabb& known = context_.contacts.covered();
        return std::min({foot_.x() - known.min.x(), known.max.x() - foot_.x(), foot_.z() - known.min.z(),
                         known.max.z() - foot_.z()}) -
               wall_reach_;
    }
    double room_above_and_below() const {
        const Aabb& known = context_.contacts.covered();
        return std::min(foot_.y() - known.min.y(), known.max.y() - foot_.y() - body_.height) -
               (wall_reach_ - body_.radius);
    }

    /// A step that it climbs would be as high as its head: then what it could stand on isn't beside it only.
    bool is_too_low(double length) const {
        const double highest = std::max(body_.step_height + body_.radius, context_.steepest * length);
        return highest + 2.0 * kHeightSlack > body_.height - 2.0 * body_.radius;
    }

    const Vec3& up() const { return floor_.faces[0].up; }

    /// The one or two that carry it, and how far its circle is within them.
    bool find_faces() {
        const Vec3 middle = foot_ + Vec3(0, body_.radius, 0);
        for (const ContactCache::Index i : context_.near) {
            const ContactCache::Piece& piece = context_.contacts.piece(i);
            const Obstacle& o = piece.obstacle;
            if (!piece.walkable) {
                continue;
            }
            const Vec3 up = o.normal.y() > 0.0 ? o.normal : Vec3(-o.normal);
            if (std::abs(up.dot(middle - o.vertices.a) - reach_) > kOnFace) {
                continue;
            }
            const double within =
                up.y() * (depth_inside(o.vertices, o.normal, middle - reach_ * up) - kAside);
            if (within < kSmallest) {
                continue;
            }
            if (floor_.face_count == floor_.faces.size() ||
                (floor_.face_count > 0 && (up - this->up()).cwiseAbs().maxCoeff() > kFlush)) {
                return false;
            }
            indices_[floor_.face_count] = i;
            floor_.faces[floor_.face_count++] = {o.vertices.a, up};
            floor_.radius = std::min(floor_.radius, within);
        }
        return floor_.face_count > 0;
    }

    bool is_face(ContactCache::Index i) const {
        const auto faces = std::span(indices_).first(floor_.face_count);
        return std::ranges::find(faces, i) != faces.end();
    }

    void limit_by(ContactCache::Index i) {
        const ContactCache::Piece& piece = context_.contacts.piece(i);
        if (radius_beside(piece, context_.contacts.known_distance(i, foot_)) < floor_.radius) {
            const double distance = context_.contacts.measure(i, foot_).distance;
            floor_.radius = std::min(floor_.radius, radius_beside(piece, distance));
        }
    }

    /// How far the foot may go if the piece is at this distance from the body's core now.
    double radius_beside(const ContactCache::Piece& piece, double distance) const {
        const double height = is_passed_over(piece) ? height_over_face(piece.obstacle.vertices) : 1.0;
        if (height < -kBeyond - kFlush) {
            return std::numeric_limits<double>::infinity();
        }
        if (height <= kFlush) {
            const double aside2 = squared(distance) - squared(reach_ + kBeyond);
            return up().y() * (std::sqrt(std::max(0.0, aside2)) - kAside);
        }
        return up().y() * (distance - wall_reach_);
    }

    /// Whether it is a floor and no wall, wherever the body stands in the circle.
    bool is_passed_over(const ContactCache::Piece& piece) const {
        const double top = piece.obstacle.top;
        return piece.obstacle.solid == nullptr &&
               (top <= lowest_ || (piece.walkable && top <= lowest_ + body_.step_height));
    }

    /// Of its highest vertex.
    double height_over_face(const Triangle& t) const {
        const Vec3& on_face = floor_.faces[0].vertex;
        return std::max({up().dot(t.a - on_face), up().dot(t.b - on_face), up().dot(t.c - on_face)});
    }

    MoveContext& context_;
    const MoverSettings& body_;
    const Vec3& foot_;
    double reach_;         ///< from the core to the face that it stands on
    double wall_reach_;    ///< from the core to where walls begin to matter
    double lowest_ = 0.0;  ///< foot in the circle
    OpenFloor floor_;
    std::array<ContactCache::Index, 2> indices_{};  ///< of the faces
};

std::optional<FloorPlace> OpenFloors::walk(const MoverSettings& body, const Vec3& foot, const Vec3& desired) {
    const Vec3 goal = foot + desired;
    const OpenFloor* floor = find(foot, goal);
    if (floor == nullptr || !(desired.squaredNorm() <= squared(floor->length))) {
        return std::nullopt;
    }
    const double reach = body.radius + kRestGap;
    double before = -std::numeric_limits<double>::infinity();
    double after = before;
    FloorPlace place{goal, before};
    for (std::size_t i = 0; i < floor->face_count; ++i) {
        const Face& face = floor->faces[i];
        const SphereRest rest = rest_on_face(face.vertex, face.up, goal.x(), goal.z(), reach);
        before = std::max(before, rest_on_face(face.vertex, face.up, foot.x(), foot.z(), reach).height);
        after = std::max(after, rest.height);
        place.support_y = std::max(place.support_y, rest.on.y());
    }
    if (!(std::abs(before - body.radius - foot.y()) <= kOnFace)) {
        return std::nullopt;
    }
    place.foot.y() = after - body.radius;
    return place;
}

const OpenFloors::OpenFloor* OpenFloors::find(const Vec3& from, const Vec3& to) {
    if (floors_.empty()) {
        return nullptr;
    }
    const auto has_both = [&](const OpenFloor& floor) {
        return floor.radius > 0.0 && horizontal_distance2(floor.center, from) <= squared(floor.radius) &&
               horizontal_distance2(floor.center, to) <= squared(floor.radius);
    };
    if (!has_both(floors_[last_])) {
        const std::size_t slot = slot_of(from);
        if (!has_both(floors_[slot])) {
            return nullptr;
        }
        last_ = slot;
    }
    return &floors_[last_];
}

void OpenFloors::learn(MoveContext& context, const Vec3& foot, double length) {
    if (pause_ > 0) {
        --pause_;
        return;
    }
    const auto floor = Survey(context, foot, length).find();
    if (!floor) {
        pause_ = kPause;
        return;
    }
    floors_.resize(kFloors);
    last_ = slot_of(foot);
    floors_[last_] = *floor;
}

void OpenFloors::clear() {
    floors_.clear();
    last_ = 0;
    pause_ = 0;
}

}  // namespace campuswalk::collision
