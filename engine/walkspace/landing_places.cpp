#include "engine/walkspace/landing_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <variant>

#include "collision/mesh/mesh_collider.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

constexpr double kBlock = 2.0;  // metres
/// A body that touches slopes and walls on its way gets farther than one that falls freely.
constexpr double kSlides = 1.5;
constexpr double kBeside = 0.5;  // metres
/// A surface and a node this near in height are one, metres.
constexpr double kSameLevel = 0.3;

class LandingPlaces {
public:
    LandingPlaces(const collision::World& world, const ExploreSettings& settings, const WalkSpace& reached,
                  const std::vector<FallEdge>& edges)
        : world_(world), settings_(settings), grid_(reached.grid), bottom_(world.bounds().min.y()) {
        collision::Aabb region;
        for (const FallEdge& edge : edges) {
            region.extend(bounds_below(edge));
        }
        if (!region.empty()) {
            for (const Surface& surface : unreached_surfaces(world, settings, reached, region)) {
                if (!is_explored_elsewhere(surface)) {
                    blocks_[key_of(WalkGrid{kBlock}.cell_at(grid_.center(surface.cell)))].push_back(surface);
                }
            }
        }
    }

    bool has_any_below(const FallEdge& edge) {
        const collision::Aabb bounds = bounds_below(edge);
        if (has_round_solid(bounds)) {
            return true;
        }
        const WalkGrid grid{kBlock};
        const GridCell first = grid.cell_at(bounds.min);
        const GridCell last = grid.cell_at(bounds.max);
        for (int z = first.z; z <= last.z; ++z) {
            for (int x = first.x; x <= last.x; ++x) {
                const auto block = blocks_.find(key_of({x, z}));
                if (block != blocks_.end() &&
                    std::ranges::any_of(block->second, [&](const Surface& s) { return is_below(s, edge); })) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    /// The exploration doesn't go there.
    bool is_explored_elsewhere(const Surface& surface) const {
        Vec3 foot = grid_.center(surface.cell);
        foot.y() = surface.y;
        return (!settings_.within.empty() && !settings_.within.overlaps({foot, foot})) ||
               (settings_.known != nullptr && settings_.known->find(surface.cell, surface.y, kSameLevel));
    }

    static std::uint64_t key_of(const GridCell& block) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(block.x)) << 32U |
               static_cast<std::uint32_t>(block.z);
    }

    /// Even if the body has no room there: on a narrow ledge it may hang over the edge.
    bool is_below(const Surface& surface, const FallEdge& edge) const {
        return collision::horizontal_norm(grid_.center(surface.cell) - edge.at) <= reach_at(edge, surface.y);
    }

    /// How far ahead a body gets before it falls below `y`; less than nothing if it never gets so high.
    double reach_at(const FallEdge& edge, double y) const {
        const StrideSettings& strides = settings_.strides;
        const double gravity = strides.body.gravity;
        const double upwards = edge.gait == Gait::jump ? strides.jump_speed : 0.0;
        const double left = upwards * upwards + 2.0 * gravity * (edge.at.y() - y);
        if (left < 0.0) {
            return -1.0;
        }
        const double seconds = (upwards + std::sqrt(left)) / gravity + 2.0 * strides.seconds;
        const double speed = edge.gait == Gait::walk ? strides.walk_speed : strides.run_speed;
        return kSlides * speed * seconds + strides.body.radius + grid_.cell + kBeside;
    }

    collision::Aabb bounds_below(const FallEdge& edge) const {
        const double reach = reach_at(edge, bottom_);
        const double rise = edge.gait == Gait::jump ? settings_.strides.jump_speed : 0.0;
        return {{edge.at.x() - reach, bottom_, edge.at.z() - reach},
                {edge.at.x() + reach, edge.at.y() + 0.5 * rise * rise / settings_.strides.body.gravity,
                 edge.at.z() + reach}};
    }

    /// Their tops are no surfaces.
    bool has_round_solid(const collision::Aabb& bounds) {
        world_.candidates(bounds, settings_.solids, solids_);
        return std::ranges::any_of(solids_, [&](collision::ObjectId id) {
            const collision::Shape& shape = world_.object(id).shape;
            return !std::holds_alternative<std::shared_ptr<const collision::MeshCollider>>(shape) &&
                   !std::holds_alternative<collision::Box>(shape);
        });
    }

    const collision::World& world_;
    const ExploreSettings& settings_;
    const WalkGrid grid_;
    double bottom_;
    std::unordered_map<std::uint64_t, std::vector<Surface>> blocks_;
    std::vector<collision::ObjectId> solids_;
};

}  // namespace

std::vector<bool> edges_above_new_ground(const collision::World& world, const ExploreSettings& settings,
                                         const WalkSpace& reached, const std::vector<FallEdge>& edges) {
    LandingPlaces places(world, settings, reached, edges);
    std::vector<bool> above;
    for (const FallEdge& edge : edges) {
        above.push_back(places.has_any_below(edge));
    }
    return above;
}

}  // namespace campuswalk::engine
