#include "collision/world/placement.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <tuple>
#include <vector>

#include "collision/geometry/closest.h"
#include "collision/geometry/trigonometry.h"
#include "collision/mesh/mesh_query.h"
#include "collision/world/obstacle.h"

namespace campuswalk::collision {

namespace {

/// Whether a point in the shape's frame is inside it.
struct Holds {
    const Vec3& point;
    QueryStatistics* statistics;

    bool operator()(const std::shared_ptr<const MeshCollider>& mesh) const {
        return is_inside(*mesh, point, statistics);
    }
    template <typename Solid>
    bool operator()(const Solid& solid) const {
        return closest(Segment{point, point}, solid, Pose{}).distance <= 0.0;
    }
};

constexpr double kLift = 0.05;       // metres between the heights tried
constexpr double kRing = 0.02;       // metres between the rings tried
constexpr int kDirections = 64;      // on a ring
constexpr double kRounding = 2e-3;   // metres
constexpr double kClearance = 1e-3;  // metres left between a body and what it is pushed out of
constexpr int kHalvings = 16;        // of an offset, down to a few micrometres

/// Whether a capsule, given in the world, touches the shape during a move.
struct IsSweptOver {
    const World& world;
    ObjectId id;
    const Segment& axis;
    double radius;
    const Vec3& move;
    QueryStatistics* statistics;

    bool operator()(const std::shared_ptr<const MeshCollider>& mesh) const {
        const Pose& X = world.object(id).X_world_shape;
        const Segment local{X.inverse_apply(axis.a), X.inverse_apply(axis.b)};
        return sweep(*mesh, local, radius, X.rotation.transpose() * move, statistics).has_value();
    }
    template <typename Solid>
    bool operator()(const Solid&) const {
        add_to(statistics, {.primitive_tests = 1});
        return sweep(axis, radius, move, solid_obstacle(world, id)).has_value();
    }
};

/// The first object that a point is inside of.
std::optional<ObjectId> object_around(const World& world, const QueryFilter& filter, const Vec3& point,
                                      QueryStatistics* statistics) {
    std::vector<ObjectId> candidates;
    world.candidates(Aabb{point, point}, filter, candidates);
    const auto found = std::ranges::find_if(
        candidates, [&](ObjectId id) { return contains(world.object(id), point, statistics); });
    return found == candidates.end() ? std::nullopt : std::optional(*found);
}

/// 0, then as much as the rounding of written numbers makes a body overlap the ground, then even steps.
double lift_of(int step) {
    return step < 2 ? step * kRounding : (step - 1) * kLift;
}

/// All offsets up to `reach` at which a body is tried, the nearest first.
std::vector<Vec3> offsets_within(double reach) {
    struct Offset {
        double squared = 0.0;
        int number = 0;  // breaks ties
        Vec3 vector = Vec3::Zero();
    };
    constexpr double kTurn = 2.0 * std::numbers::pi;
    std::array<Vec3, kDirections> directions;
    for (int i = 0; i < kDirections; ++i) {
        const auto [sin, cos] = sin_cos(kTurn * i / kDirections);
        directions[static_cast<std::size_t>(i)] = Vec3(cos, 0, sin);
    }
    std::vector<Offset> offsets;
    for (int step = 0; lift_of(step) <= reach; ++step) {
        for (int ring = 0; ring * kRing <= reach; ++ring) {
            for (const Vec3& direction : directions) {
                const Vec3 vector = ring * kRing * direction + Vec3(0, lift_of(step), 0);
                if (const double squared = vector.squaredNorm(); squared <= reach * reach) {
                    offsets.push_back({squared, static_cast<int>(offsets.size()), vector});
                }
                if (ring == 0) {
                    break;
                }
            }
        }
    }
    std::ranges::sort(offsets, {}, [](const Offset& o) { return std::tuple(o.squared, o.number); });
    std::vector<Vec3> vectors;
    vectors.reserve(offsets.size());
    for (const Offset& offset : offsets) {
        vectors.push_back(offset.vector);
    }
    return vectors;
}

/// Pushes a body out of what it overlaps at a place.
class Push {
public:
    Push(const World& world, const QueryFilter& filter, const Vec3& foot, double radius, double height,
         QueryStatistics* statistics)
        : world_(world),
          filter_(filter),
          foot_(foot),
          radius_(radius),
          height_(height),
          statistics_(statistics),
          axis_(upright_axis(foot, radius, height)) {
        const Segment reach{axis_.a, axis_.b + Vec3(0, 2.0 * radius, 0)};
        gather_obstacles(world, filter, reach, 3.0 * radius + kClearance, pieces_, statistics);
        for (const Obstacle& piece : pieces_) {
            const bool overlapped = closest(axis_, piece).distance < radius;
            distances_.push_back(overlapped ? radius + kClearance : radius);
        }
    }

    /// A body that overlaps a wall by its radius or more may have been meant for either side.
    bool shallow() const {
        return !object_around(world_, filter_, axis_.a, statistics_) &&
               std::ranges::none_of(
                   pieces_, [&](const Obstacle& piece) { return closest(axis_, piece).distance <= 0.0; });
    }

    std::optional<Vec3> nearest() const {
        // Several directions on one ring may be free: the one that can be moved back farthest wins.
        std::optional<Vec3> best;
        double reach = 2.0 * radius_;
        for (const Vec3& offset : offsets_within(reach)) {
            if (offset.norm() > reach) {
                break;
            }
            if (!is_free(offset)) {
                continue;
            }
            if (!best) {
                reach = std::min(reach, offset.norm() + kRing);
            }
            if (const Vec3 nearer = moved_back(offset); !best || nearer.squaredNorm() < best->squaredNorm()) {
                best = nearer;
            }
        }
        return best ? std::optional<Vec3>(foot_ + *best) : std::nullopt;
    }

private:
    bool is_free(const Vec3& offset) const {
        const Segment there{axis_.a + offset, axis_.b + offset};
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const Obstacle& piece = pieces_[i];
            if (closest(there, piece).distance < distances_[i] ||
                closest(Segment{axis_.a, there.a}, piece).distance <= 0.0 ||
                closest(Segment{axis_.b, there.b}, piece).distance <= 0.0) {
                return false;
            }
        }
        return !obstruction(world_, filter_, foot_ + offset, radius_, height_, statistics_);
    }

    Vec3 moved_back(const Vec3& offset) const {
        double blocked = 0.0;
        double enough = 1.0;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (blocked + enough);
            (is_free(middle * offset) ? enough : blocked) = middle;
        }
        return enough * offset;
    }

    const World& world_;
    const QueryFilter& filter_;
    Vec3 foot_;
    double radius_;
    double height_;
    QueryStatistics* statistics_;
    Segment axis_;
    std::vector<Obstacle> pieces_;
    std::vector<double> distances_;  ///< least distance of the axis from each piece, metres
};

}  // namespace

bool contains(const Object& object, const Vec3& point, QueryStatistics* statistics) {
    const Vec3 local = object.X_world_shape.inverse_apply(point);
    return std::visit(Holds{local, statistics}, object.shape);
}

std::optional<ObjectId> obstruction(const World& world, const QueryFilter& filter, const Vec3& foot,
                                    double radius, double height, QueryStatistics* statistics) {
    const Segment body = upright_axis(foot, radius, height);
    std::vector<Obstacle> pieces;
    gather_obstacles(world, filter, body, radius, pieces, statistics);
    std::optional<ObjectId> worst;
    double least = radius;
    for (const Obstacle& piece : pieces) {
        if (const double distance = closest(body, piece).distance; distance < least) {
            worst = piece.object;
            least = distance;
        }
    }
    return worst ? worst : object_around(world, filter, body.a, statistics);
}

std::optional<Vec3> free_place(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                               double height, double search, QueryStatistics* statistics) {
    for (int i = 0; i * kLift <= search; ++i) {
        const Vec3 tried = foot + Vec3(0, i * kLift, 0);
        if (!obstruction(world, filter, tried, radius, height, statistics)) {
            return tried;
        }
    }
    return std::nullopt;
}

bool is_path_free(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                  double height, const Vec3& move, QueryStatistics* statistics) {
    const Segment axis = upright_axis(foot, radius, height);
    Aabb swept;
    for (const Vec3& end : {axis.a, axis.b}) {
        swept.extend(end);
        swept.extend(end + move);
    }
    std::vector<ObjectId> candidates;
    world.candidates(swept.grown(radius), filter, candidates);
    return std::ranges::none_of(candidates, [&](ObjectId id) {
        return std::visit(IsSweptOver{world, id, axis, radius, move, statistics}, world.object(id).shape);
    });
}

std::optional<FreePlacement> nearest_free_placement(const World& world, const QueryFilter& filter,
                                                    const Vec3& foot, double radius, double height,
                                                    double search, QueryStatistics* statistics) {
    if (const auto here = free_place(world, filter, foot, radius, height, kLift, statistics)) {
        return FreePlacement{*here, std::nullopt};
    }
    const auto blocking = obstruction(world, filter, foot, radius, height, statistics);
    if (const Push push(world, filter, foot, radius, height, statistics); push.shallow()) {
        if (const auto beside = push.nearest()) {
            return FreePlacement{*beside, blocking};
        }
        return std::nullopt;
    }
    if (const auto above = free_place(world, filter, foot, radius, height, search, statistics)) {
        return FreePlacement{*above, blocking};
    }
    return std::nullopt;
}

}  // namespace campuswalk::collision
