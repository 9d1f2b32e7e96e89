#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// A building is a house or a course (walk_course.h).
enum class CampusPart : std::uint8_t { terrain, building, tree, bench, lamp };

/// A range of triangles of one kind, up to the next run's `first_triangle`.
struct CampusRun {
    CampusPart part = CampusPart::terrain;
    std::size_t first_triangle = 0;
};

/// Starts a run at the current end of `mesh`.
inline void begin_run(std::vector<CampusRun>& runs, CampusPart part, const collision::TriangleMesh& mesh) {
    runs.push_back({part, mesh.triangles.size()});
}

}  // namespace campuswalk::tools::bench
