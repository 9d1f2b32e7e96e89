#pragma once

#include <cstdint>

namespace campuswalk::collision {

/// The work of queries in the terms of the paper's eq. (4), T = Nv Cv + Np Cp + Nu Cu. Queries add their work
/// to the one passed in, if any. Not shared between threads.
struct QueryStatistics {
    std::uint64_t volume_tests = 0;       ///< Nv: bounding volumes tested; a node with two layers counts once
    std::uint64_t primitive_tests = 0;    ///< Np: triangles and convex solids tested
    std::uint64_t transform_updates = 0;  ///< Nu: transforms updated because of a move
    std::uint64_t sphere_tests = 0;       ///< outer spheres tested, eq. (1)
    std::uint64_t box_tests = 0;  ///< inner layers tested: in the hybrid tree, where eq. (1) left it open

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

/// Adds a query's work to `sink`, if there is one.
inline void add_to(QueryStatistics* sink, const QueryStatistics& work) {
    if (sink != nullptr) {
        *sink += work;
    }
}

}  // namespace campuswalk::collision
