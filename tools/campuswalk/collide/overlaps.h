#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/geometry/triangle_pair.h"
#include "tools/campuswalk/collide/body.h"

namespace campuswalk::tools::collide {

/// Where two bodies overlap. Meshes are surfaces, solids are filled; touching counts as
/// overlapping.
struct Overlaps {
    bool any = false;
    std::vector<collision::TrianglePair> pairs;  ///< of two meshes, ascending
    std::vector<std::uint32_t> triangles;        ///< of the one mesh that a solid overlaps, ascending
    std::optional<double> distance;              ///< of two solids, metres

    /// Of pairs or triangles; 1 for two solids that overlap.
    std::size_t count() const;
};

/// All pairs or triangles, or one: of two meshes the pair that is found first, else the lowest triangle.
enum class SearchMode : std::uint8_t { all, first };

Overlaps find_overlaps(const Body& a, const Body& b, const collision::Pose& X_a_b, SearchMode mode);

}  // namespace campuswalk::tools::collide
