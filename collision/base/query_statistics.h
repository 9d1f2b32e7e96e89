#pragma once

#include <cstdint>

namespace campuswalk::collision {

/// The work of queries in the terms of the paper's eq. (4), T = Nv Cv + Np Cp + Nu Cu. Queries add to one if
/// they are given one; a thread has its own.
struct QueryStatistics {
    std::uint64_t volume_tests = 0;       ///< Nv: bounding volumes tested; a node of two layers is one
    std::uint64_t primitive_tests = 0;    ///< Np: triangles and convex solids tested
    std::uint64_t transform_updates = 0;  ///< Nu: transforms that a move made it bring up to date
    std::uint64_t sphere_tests = 0;       ///< outer spheres tested, eq. (1)
    std::uint64_t box_tests = 0;  ///< inner layers tested: in the hybrid tree where eq. (1) didn't decide

    QueryStatistics& operator+=(const QueryStatistics& o) {
        volume_tests += o.volume_tests;
        primitive_tests += o.primitive_tests;
        transform_updates += o.transform_updates;
        sphere_tests += o.sphere_tests;
        box_tests += o.box_tests;
        return *this;
    }
    friend QueryStatistics operator-(QueryStatistics a, const QueryStatistics& b) {
        a.volume_tests -= b.volume_tests;
        a.primitive_tests -= b.primitive_tests;
        a.transform_updates -= b.transform_updates;
        a.sphere_tests -= b.sphere_tests;
        a.box_tests -= b.box_tests;
        return a;
    }
};

/// Adds a query's work to the sink that it was given, if any.
inline void add_to(QueryStatistics* sink, const QueryStatistics& work) {
    if (sink != nullptr) {
        *sink += work;
    }
}

}  // namespace campuswalk::collision
