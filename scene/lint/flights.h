#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// Treads that one climbs one after another.
struct Flight {
    std::size_t node = 0;  ///< that holds all of them; their first one's if only the root does
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();  ///< world, the middle of the lowest tread
    /// Metres, from the ground in front of the lowest tread to the landing behind the highest, as far as
    /// there is either.
    std::vector<double> risers;
    double tread_depth = 0.0;  ///< metres from one edge to the next in plan, the median
    double width = 0.0;        ///< metres, the median
};

/// Finds stairs by their geometry: three or more level surfaces of a tread's size, each behind the one below
/// and at most 0.6 m above it. Winders count; slabs that reach below the whole flight don't. In order of
/// nodes.
std::vector<Flight> find_flights(const Model& model);

/// The median riser.
double usual_riser(const Flight& flight);

}  // namespace campuswalk::scene
