#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/world.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

/// Where a person can stand and walk on a mesh: a grid of squares of half a metre, on each the heights of its
/// floors. Two neighbours are connected if a person fits on both and in between, and no step is higher than
/// 30 cm. A guess for suggestions: only a walk tells for certain.
class WalkableGround {
public:
    struct Spot {
        collision::Vec3 foot = collision::Vec3::Zero();
        bool open_sky = false;            ///< nothing above it
        bool upstairs = false;            ///< a roof or an upper floor: there is a spot below it
        std::vector<std::uint32_t> next;  ///< connected neighbours, one or, over a step, two squares away
        std::uint32_t part = 0;           ///< spots of one part can be reached from one another
        std::uint32_t edge_distance = 0;  ///< steps to the nearest spot that lacks a neighbour
    };

    /// Looks at a square of 150 m about `middle`, or all of the mesh if that is less.
    WalkableGround(const std::shared_ptr<const collision::MeshCollider>& mesh,
                   const collision::Vec3& p_world_origin, const collision::Vec3& middle);

    const std::vector<Spot>& spots() const { return spots_; }

    /// In the largest part, where spots upstairs count once, others twice and under the open sky eight times.
    /// There, each if it can be: not
    /// upstairs, under the open sky, half a metre from all `boxes`, as far as eight metres from every edge;
    /// near `middle`. None if nobody can stand anywhere.
    std::optional<std::uint32_t> best_spawn_spot(const collision::Vec3& middle,
                                                 const std::vector<UprightBox>& boxes) const;

    /// How many spots can be reached from one of them, itself included.
    std::size_t count_reachable(std::uint32_t spot) const;

    /// By spot: the one before it on a shortest way from `start`, itself for the start and for what can't be
    /// reached. Ways keep a step from edges where that is possible.
    std::vector<std::uint32_t> shortest_paths_from(std::uint32_t start) const;

    /// A few of the spots on the way from `start` to `end`, both included, between which a straight line
    /// stays on the ground.
    std::vector<collision::Vec3> waypoints(const std::vector<std::uint32_t>& ways, std::uint32_t end) const;

private:
    struct Column {
        std::vector<std::uint32_t> spots;
    };

    /// `search`: how much higher than the floor below its middle a body may have to stand.
    void find_floors(const collision::MeshCollider& mesh, const collision::Vec3& p_world_origin,
                     double search);
    void connect();
    /// Whether it is with any of the column's.
    bool connect(std::uint32_t a, const Column& column);
    void number_parts();
    void measure_edges();
    bool is_straight(const collision::Vec3& from, const collision::Vec3& to) const;
    const Column& column_at(std::int64_t x, std::int64_t z) const {
        return columns_[static_cast<std::size_t>(z * width_ + x)];
    }

    collision::World world_;
    collision::Vec3 corner_ = collision::Vec3::Zero();
    std::int64_t width_ = 0;
    std::int64_t depth_ = 0;
    std::vector<Column> columns_;
    std::vector<Spot> spots_;
};

}  // namespace campuswalk::scene
