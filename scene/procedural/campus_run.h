#pragma once

#include <cstddef>
#include <cstdint>

namespace campuswalk::scene {

/// A building is a house or a course (walk_course.h).
enum class CampusPart : std::uint8_t { terrain, building, tree, bench, lamp };

/// Triangles of one kind: from `first_triangle` to the next run's.
struct CampusRun {
    CampusPart part = CampusPart::terrain;
    std::size_t first_triangle = 0;
};

}  // namespace campuswalk::scene
