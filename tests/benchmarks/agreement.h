#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "collision/ray.h"
#include "collision/shapes.h"
#include "collision/triangle_mesh.h"

namespace campuswalk::bench {

/// Where two answers differ, plain formulas over all triangles decide who is right.
struct Agreement {
    std::size_t same = 0;
    std::size_t too_close_to_call = 0;  ///< the answer turns on less than rounding
    std::size_t peer_wrong = 0;
    std::size_t ours_wrong = 0;
};

void compare_hits(const collision::TriangleMesh& mesh, const collision::Ray& ray, std::optional<double> ours,
                  std::optional<double> peer, Agreement& agreement);

/// Both ascending.
void compare_sets(const collision::TriangleMesh& mesh, const collision::Segment& segment, double radius,
                  std::span<const std::uint32_t> ours, std::span<const std::uint32_t> peer,
                  Agreement& agreement);

void print_agreement(const char* peer_name, const Agreement& agreement);

}  // namespace campuswalk::bench
