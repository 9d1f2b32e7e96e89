#include "engine/walkspace/landing_places.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>

#include "collision/mesh/mesh_collider.h"
#include "engine/walkspace/unreached_surfaces.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

constexpr WalkGrid kBlocks{2.0};
/// A body that touches slopes on its way gets farther than one that falls freely.
constexpr double kSlides = 1.5;
/// It may land this much farther from where it is expected, metres.
constexpr double kBeside = 0.5;
/// A surface and a node this near in height are one, metres.
constexpr double kSameLevel = 0.3;

std::uint64_t key_of(const GridCell& block) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(block.x)) << 32U |
           static_cast<std::uint32_t>(block.z);
}

bool is_round(const collision::Shape& shape) {
    return !std::holds_alternative<std::shared_ptr<const collision::MeshCollider>>(shape) &&
           !std::holds_alternative<collision::Box>(shape);
}

}  // namespace

LandingPlaces::LandingPlaces(const collision::World& world, const ExploreSettings& settings,
                             const WalkSpace& reached, const std::vector<FallEdge>& edges)
    : settings_(settings), bottom_(world.bounds().min.y()) {
    collision::Aabb region;
    for (const FallEdge& edge : edges) {
        region.extend(region_below(edge));
    }
    if (!region.empty()) {
        add_surfaces(world, reached, region);
        add_round_solids(world, region);
    }
}

void LandingPlaces::add_surfaces(const collision::World& world, const WalkSpace& reached,
                                 const collision::Aabb& region) {
    for (const Surface& surface : unreached_surfaces(world, settings_, reached, region)) {
        Vec3 at = reached.grid.center(surface.cell);
        at.y() = surface.y;
        if (!is_explored_elsewhere(at)) {
            add(at);
        }
    }
}

/// Their tops are no surfaces.
void LandingPlaces::add_round_solids(const collision::World& world, const collision::Aabb& region) {
    std::vector<collision::ObjectId> solids;
    world.candidates(region, settings_.solids, solids);
    for (const collision::ObjectId id : solids) {
        if (is_round(world.object(id).shape)) {
            round_solids_.push_back(world.bounds(id));
        }
    }
}

void LandingPlaces::add(const Vec3& at) {
    blocks_[key_of(kBlocks.cell_at(at))].push_back(at);
}

/// The exploration doesn't go there.
bool LandingPlaces::is_explored_elsewhere(const Vec3& at) const {
    return (!settings_.within.empty() && !settings_.within.overlaps({at, at})) ||
           (settings_.known != nullptr &&
            settings_.known->find(settings_.known->grid.cell_at(at), at.y(), kSameLevel));
}

/// Even if the body has no room there: on a narrow ledge it may hang over the edge.
Landings LandingPlaces::below(const FallEdge& edge) const {
    Landings landings;
    const double reach = reach_after(edge, seconds_to(edge, bottom_));
    const collision::Aabb region = region_below(edge);
    landings.anywhere = std::ranges::any_of(
        round_solids_, [&](const collision::Aabb& bounds) { return bounds.overlaps(region); });
    const GridCell first = kBlocks.cell_at(edge.at - Vec3(reach, 0, reach));
    const GridCell last = kBlocks.cell_at(edge.at + Vec3(reach, 0, reach));
    for (int z = first.z; z <= last.z; ++z) {
        for (int x = first.x; x <= last.x; ++x) {
            const auto block = blocks_.find(key_of({x, z}));
            if (block == blocks_.end()) {
                continue;
            }
            for (const Vec3& at : block->second) {
                const double seconds = seconds_to(edge, at.y());
                const Vec3 offset(at.x() - edge.at.x(), 0.0, at.z() - edge.at.z());
                if (seconds >= 0.0 && offset.norm() <= reach_after(edge, seconds)) {
                    landings.list.push_back({offset, seconds});
                }
            }
        }
    }
    return landings;
}

/// Along a wall a body gets as far as its way's projection on it: to the circle whose diameter is the way
/// that it would have gone.
bool LandingPlaces::may_land_on(const Landings& landings, const Stride& stride) const {
    const double speed = speed_of(stride.gait);
    const double seconds_ahead = Stride::kFifth * stride.steers_after;
    const bool steers = stride.steering != Stride::kLetGo;
    const Vec3& straight_on = grid_directions()[stride.direction].unit;
    const Vec3& steered = steers && stride.steering != Stride::kStraightOn
                              ? grid_directions()[stride.steering].unit
                              : straight_on;
    const double beside = settings_.strides.body.radius + kBeside;
    const auto is_near = [&](const Landing& landing) {
        const double whole = speed * landing.seconds;
        const double ahead = std::min(whole, speed * seconds_ahead);
        const double after = steers ? whole - ahead : 0.0;
        const Vec3 middle = 0.5 * ahead * straight_on + 0.5 * after * steered;
        return (landing.offset - middle).norm() <= 0.5 * (ahead + after) + (kSlides - 1.0) * whole + beside;
    };
    return landings.anywhere || std::ranges::any_of(landings.list, is_near);
}

/// Until a body that leaves the ground there falls below `y`; negative if it never gets so high.
double LandingPlaces::seconds_to(const FallEdge& edge, double y) const {
    const StrideSettings& strides = settings_.strides;
    const double upwards = edge.gait == Gait::jump ? strides.jump_speed : 0.0;
    const double left = upwards * upwards + 2.0 * strides.body.gravity * (edge.at.y() - y);
    return left < 0.0 ? -1.0
                      : std::min((upwards + std::sqrt(left)) / strides.body.gravity + 2.0 * strides.seconds,
                                 kMaxFall);
}

collision::Aabb LandingPlaces::region_below(const FallEdge& edge) const {
    const double reach = reach_after(edge, seconds_to(edge, bottom_));
    const double upwards = edge.gait == Gait::jump ? settings_.strides.jump_speed : 0.0;
    const double rise = 0.5 * upwards * upwards / settings_.strides.body.gravity;
    return {{edge.at.x() - reach, bottom_, edge.at.z() - reach},
            {edge.at.x() + reach, edge.at.y() + rise, edge.at.z() + reach}};
}

double LandingPlaces::speed_of(Gait gait) const {
    return gait == Gait::walk ? settings_.strides.walk_speed : settings_.strides.run_speed;
}

double LandingPlaces::reach_after(const FallEdge& edge, double seconds) const {
    return kSlides * speed_of(edge.gait) * std::max(0.0, seconds) + settings_.strides.body.radius + kBeside;
}

}  // namespace campuswalk::engine
