#include "engine/walkspace/explore/landing_places.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>

#include "collision/mesh/mesh_collider.h"
#include "engine/walkspace/explore/unreached_surfaces.h"

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

bool is_round(const collision::Shape& shape) {
    return !std::holds_alternative<std::shared_ptr<const collision::MeshCollider>>(shape) &&
           !std::holds_alternative<collision::Box>(shape);
}

}  // namespace

LandingPlaces::LandingPlaces(const WorkerWorlds& worlds, const ExploreSettings& settings,
                             const WalkSpace& reached, const std::vector<FallEdge>& edges)
    : settings_(settings), bottom_(worlds[0].bounds().min.y()) {
    collision::Aabb region;
    for (const FallEdge& edge : edges) {
        region.extend(region_below(edge));
    }
    if (!region.empty()) {
        add_surfaces(worlds, reached, region);
        add_round_solids(worlds[0], region);
    }
}

void LandingPlaces::add_surfaces(const WorkerWorlds& worlds, const WalkSpace& reached,
                                 const collision::Aabb& region) {
    const auto surfaces = unreached_surfaces(worlds, settings_, reached, region);
    for (const Surface& surface :
         surfaces.value_or(std::vector<Surface>())) {  // too many: none is steered to
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
    blocks_[kBlocks.cell_at(at)].push_back(at);
}

/// The exploration doesn't go there.
bool LandingPlaces::is_explored_elsewhere(const Vec3& at) const {
    return (!settings_.within.empty() && !settings_.within.overlaps({at, at})) ||
           std::ranges::any_of(settings_.known, [&](const WalkSpace* known) {
               return known->find(known->grid.cell_at(at), at.y(), kSameLevel).has_value();
           });
}

/// Even if the body has no room to stand there: on a narrow ledge it may hang over the edge.
bool LandingPlaces::has_any_below(const FallEdge& edge) const {
    const collision::Aabb region = region_below(edge);
    if (std::ranges::any_of(round_solids_, [&](const collision::Aabb& b) { return b.overlaps(region); })) {
        return true;
    }
    const auto is_below = [&](const Vec3& at) {
        const double seconds = seconds_to(edge, at.y());
        return seconds >= 0.0 && collision::horizontal_norm(at - edge.at) <= reach_after(edge, seconds);
    };
    const GridCell first = kBlocks.cell_at(region.min);
    const GridCell last = kBlocks.cell_at(region.max);
    for (int z = first.z; z <= last.z; ++z) {
        for (int x = first.x; x <= last.x; ++x) {
            const auto block = blocks_.find({x, z});
            if (block != blocks_.end() && std::ranges::any_of(block->second, is_below)) {
                return true;
            }
        }
    }
    return false;
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
    const double rise = edge.gait == Gait::jump ? jump_height(settings_.strides) : 0.0;
    return {{edge.at.x() - reach, bottom_, edge.at.z() - reach},
            {edge.at.x() + reach, edge.at.y() + rise, edge.at.z() + reach}};
}

double LandingPlaces::reach_after(const FallEdge& edge, double seconds) const {
    const StrideSettings& strides = settings_.strides;
    const double speed = edge.gait == Gait::walk ? strides.walk_speed : strides.run_speed;
    return kSlides * speed * std::max(0.0, seconds) + strides.body.radius + kBeside;
}

}  // namespace campuswalk::engine
