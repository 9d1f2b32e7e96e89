#pragma once

#include <cstdint>

namespace campuswalk::collision {

/// The work of a query in the terms of the paper's eq. (4), T = Nv Cv + Np Cp + Nu Cu.
struct QueryCounters {
    std::uint64_t nv = 0;  ///< pairs of bounding volumes tested
    std::uint64_t np = 0;  ///< pairs of primitives tested
    std::uint64_t nu = 0;  ///< nodes whose transform was updated after a move

    QueryCounters& operator+=(const QueryCounters& o) {
        nv += o.nv;
        np += o.np;
        nu += o.nu;
        return *this;
    }
};

}  // namespace campuswalk::collision
