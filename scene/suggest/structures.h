#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "scene/lint/model_report.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// A nearly vertical triangle, seen from above.
struct Wall {
    Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< x, z: with `to` the two farthest points of the plan
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    double low = 0.0;  ///< its height above the world's origin, metres
    double high = 0.0;
    double area = 0.0;      ///< m²
    bool is_built = false;  ///< upright and with a level edge, as those of rocks hardly are
};

/// What walls are together.
struct WallSum {
    Bounds bounds;
    double area = 0.0;   ///< m²
    double built = 0.0;  ///< m² of those that are

    /// Whether most of them look built rather than grown.
    bool is_built() const { return 2.0 * built >= area; }
};

WallSum sum_of(const std::vector<Wall>& walls);

/// None if the triangle isn't nearly vertical, or has no area.
std::optional<Wall> wall_of(const std::array<Eigen::Vector3d, 3>& vertices);

/// A node with triangles that may belong to a building: neither it nor a group that it is in is named as
/// surroundings (is_surroundings_name).
struct Structure {
    std::size_t node = 0;  ///< index into Model::nodes
    std::vector<Wall> walls;
};

/// In the order of the nodes. Those without walls, such as roofs and floors, have none.
std::vector<Structure> find_structures(const Model& model, const ModelReport& report);

/// The pairs of structures whose walls come closer than about a metre on the plan, as indices, the smaller
/// first; ascending, unique. Where more than eight share a square metre, only enough to connect them all. If
/// the walls are longer than 2,500 km in all, they may be farther apart by as much.
std::vector<std::pair<std::size_t, std::size_t>> touching(const std::vector<Structure>& structures);

}  // namespace campuswalk::scene
