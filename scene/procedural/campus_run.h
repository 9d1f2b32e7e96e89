#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::scene {

/// A building is a house or a course (walk_course.h).
enum class CampusPart : std::uint8_t { terrain, building, tree, bench, lamp };

/// Triangles of one kind: from `first_triangle` to the next run's.
struct CampusRun {
    CampusPart part = CampusPart::terrain;
    std::size_t first_triangle = 0;
};

/// What is added to `mesh` from now on is of this kind.
inline void begin_run(std::vector<CampusRun>& runs, CampusPart part, const collision::TriangleMesh& mesh) {
    runs.push_back({part, mesh.triangles.size()});
}

}  // namespace campuswalk::scene
