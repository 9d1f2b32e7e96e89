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

/// The places where an avatar can stand and walk on a mesh: a grid of cells of 0.5 m with the heights of
/// their floors ("spots"). Adjacent spots are connected if an avatar fits on both and in between, and the
/// step is at most 0.3 m. An approximation for suggestions; only a walk gives certainty.
class WalkableGround {
public:
    struct Spot {
        collision::Vec3 foot = collision::Vec3::Zero();
        bool open_sky = false;            ///< nothing above it
        bool upstairs = false;            ///< there is a spot below: a roof or an upper floor
        std::vector<std::uint32_t> next;  ///< connected spots, one or, over a step, two cells away
        std::uint32_t component = 0;      ///< number of its connected component
        std::uint32_t edge_distance = 0;  ///< in cells, to the nearest spot without all four neighbours
    };

    /// Covers at most 150 m x 150 m around `center`.
    WalkableGround(const std::shared_ptr<const collision::MeshCollider>& mesh,
                   const collision::Vec3& p_world_origin, const collision::Vec3& center);

    const std::vector<Spot>& spots() const { return spots_; }

    /// The best place to spawn, in the largest component (spots upstairs count once, others twice, under the
    /// open sky eight times). Preferences in order: not upstairs, under the open sky, 0.5 m outside of all
    /// `boxes`, far from edges (up to 8 m), near `center`. nullopt if there is no spot.
    std::optional<std::uint32_t> best_spawn_spot(const collision::Vec3& center,
                                                 const std::vector<UprightBox>& boxes) const;

    /// The number of spots in the component of `spot`.
    std::size_t count_reachable(std::uint32_t spot) const;

    /// By spot: its predecessor on the shortest path from `start`; itself for the start and for unreachable
    /// spots. Paths avoid edges if possible.
    std::vector<std::uint32_t> shortest_paths_from(std::uint32_t start) const;

    /// The path from the start to `end`, both included, simplified to straight segments that stay on the
    /// ground.
    std::vector<collision::Vec3> waypoints(const std::vector<std::uint32_t>& predecessors,
                                           std::uint32_t end) const;

private:
    struct Column {
        std::vector<std::uint32_t> spots;
    };

    /// `search`: how far above the floor at its centre an avatar may stand.
    void find_floors(const collision::MeshCollider& mesh, const collision::Vec3& p_world_origin,
                     double search);
    void connect();
    /// Whether it could connect the spot to any of the column.
    bool connect(std::uint32_t a, const Column& column);
    void label_components();
    void measure_edge_distances();
    bool is_straight(const collision::Vec3& from, const collision::Vec3& to) const;
    const Column& column_at(std::int64_t x, std::int64_t z) const {
        return columns_[static_cast<std::size_t>(z * width_ + x)];
    }

    collision::World world_;
    collision::Vec3 origin_ = collision::Vec3::Zero();
    std::int64_t width_ = 0;
    std::int64_t depth_ = 0;
    std::vector<Column> columns_;
    std::vector<Spot> spots_;
};

}  // namespace campuswalk::scene
