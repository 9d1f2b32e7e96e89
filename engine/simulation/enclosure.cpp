#include "engine/simulation/enclosure.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "collision/geometry/trigonometry.h"
#include "collision/world/obstacle.h"
#include "collision/world/placement.h"
#include "engine/walkspace/barrier/barrier_reason.h"
#include "engine/walkspace/stride/stride.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::Obstacle;
using collision::Segment;
using collision::Vec3;

namespace {

constexpr double kPrecision = 1e-3;  // metres, of what is measured
constexpr double kOffGround = 0.02;  // metres, so that the ground isn't what is in the way
constexpr double kThinnest = 0.01;   // metres: no body has a smaller radius
// Room is looked for in rings around the body.
constexpr double kFarthestRoom = 10.0;  // metres
constexpr double kRing = 0.1;           // metres from one to the next
constexpr int kDirections = 32;

class Enclosure {
public:
    Enclosure(const scene::Campus& campus, const StoppedBody& body)
        : campus_(campus),
          body_(body),
          foot_(body.at.foot + Vec3(0, kOffGround, 0)),
          radius_(body.strides.body.radius),
          height_(std::max(body.strides.body.height - kOffGround, 2.0 * radius_)) {}

    std::optional<Barrier> headroom() const {
        const auto most = most_that_fits(2.0 * radius_, height_,
                                         [&](double height) { return is_free(foot_, radius_, height); });
        if (!most) {
            return std::nullopt;
        }
        const double above = foot_.y() + *most - radius_;  // the centre of the body's upper end
        Barrier barrier = touching(*most, radius_, [&](const Vec3& at) { return at.y() > above; });
        barrier.kind = ReasonKind::headroom;
        barrier.measured = *most + kOffGround;
        barrier.allowed = height_ + kOffGround;
        return barrier;
    }

    std::optional<Barrier> width() const {
        // A thinner body may stand a little beside its place.
        const auto most = most_that_fits(kThinnest, radius_, [&](double radius) {
            return collision::nearest_free_placement(campus_.world, body_.solids, foot_, radius, height_, 0.0)
                .has_value();
        });
        if (!most) {
            return std::nullopt;
        }
        Barrier barrier = touching(height_, *most, [](const Vec3&) { return true; });
        barrier.kind = ReasonKind::opening;
        barrier.measured = 2.0 * *most;
        barrier.allowed = 2.0 * radius_;
        return barrier;
    }

    /// The nearest point of the object's surface.
    Vec3 surface_of(ObjectId object) const {
        std::vector<Obstacle> pieces;
        collision::gather_pieces(campus_.world, object, axis(height_, radius_), kFarthestRoom, pieces);
        return nearest(pieces, height_, radius_, [](const Vec3&) { return true; }).at;
    }

    /// Where the body could stand instead, feet.
    std::optional<Vec3> nearest_room() const {
        Strider strider(campus_.world, body_.strides, body_.solids);
        for (int ring = 1; ring * kRing <= kFarthestRoom; ++ring) {
            for (int i = 0; i < kDirections; ++i) {
                const auto [sin, cos] = collision::sin_cos(2.0 * std::numbers::pi * i / kDirections);
                const Vec3 there = foot_ + ring * kRing * Vec3(sin, 0.0, -cos);
                if (!is_free(there, radius_, height_)) {
                    continue;
                }
                const StrideEnd end = strider.put_down(there);
                if (end.kind == StrideEnd::Kind::grounded && !end.left_ground) {
                    return end.at.foot;
                }
            }
        }
        return std::nullopt;
    }

private:
    Segment axis(double height, double radius) const {
        return collision::upright_axis(foot_, radius, std::max(height, 2.0 * radius));
    }

    bool is_free(const Vec3& foot, double radius, double height) const {
        return !collision::obstruction(campus_.world, body_.solids, foot, radius, height);
    }

    /// The greatest size from `least` up that fits, if `least` does and `wanted` doesn't.
    template <typename Fits>
    static std::optional<double> most_that_fits(double least, double wanted, const Fits& fits) {
        if (!fits(least) || fits(wanted)) {
            return std::nullopt;
        }
        double fitting = least;
        double too_much = wanted;
        while (too_much - fitting > kPrecision) {
            const double middle = 0.5 * (fitting + too_much);
            (fits(middle) ? fitting : too_much) = middle;
        }
        return fitting;
    }

    /// Where a body of this size touches what keeps it from being larger.
    template <typename Counts>
    Barrier touching(double height, double radius, const Counts& counts) const {
        std::vector<Obstacle> pieces;
        collision::gather_obstacles(campus_.world, body_.solids, axis(height, radius), radius + kOffGround,
                                    pieces);
        return nearest(pieces, height, radius, counts);
    }

    /// Of the pieces whose nearest point counts.
    template <typename Counts>
    Barrier nearest(const std::vector<Obstacle>& pieces, double height, double radius,
                    const Counts& counts) const {
        Barrier barrier;
        barrier.at = barrier.from = foot_;
        double least = std::numeric_limits<double>::max();
        for (const Obstacle& piece : pieces) {
            const collision::Closest closest = collision::closest(axis(height, radius), piece);
            if (closest.distance < least && counts(closest.on_shape)) {
                least = closest.distance;
                barrier.at = closest.on_shape;
                barrier.object = piece.object;
                barrier.triangle = piece.triangle;
            }
        }
        return barrier;
    }

    const scene::Campus& campus_;
    const StoppedBody& body_;
    Vec3 foot_;
    double radius_;
    double height_;
};

}  // namespace

Reason reason_of_enclosure(const scene::Campus& campus, const StoppedBody& body, ObjectId enclosed_by) {
    const Enclosure enclosure(campus, body);
    Reason reason =
        reason_about(ReasonKind::enclosed, campus, enclosed_by, enclosure.surface_of(enclosed_by));
    std::optional<Barrier> barrier = enclosure.headroom();
    if (!barrier) {
        barrier = enclosure.width();
    }
    if (barrier) {
        reason.parts.push_back(reason_of(campus, *barrier));
        reason.look_at = barrier->at;
    }
    reason.room = enclosure.nearest_room();
    if (reason.room) {
        reason.measured = (*reason.room - body.at.foot).norm();
    } else {
        reason.allowed = kFarthestRoom;
    }
    return reason;
}

std::optional<Reason> reason_of_low_headroom(const scene::Campus& campus, const StoppedBody& body) {
    const auto barrier = Enclosure(campus, body).headroom();
    return barrier ? std::optional(reason_of(campus, *barrier)) : std::nullopt;
}

}  // namespace campuswalk::engine
