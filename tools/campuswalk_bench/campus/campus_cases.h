#pragma once

#include <cstddef>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

struct CampusSize {
    int lots = 8;  ///< a side, see generated_campus.h
    std::size_t rays = 5000;
    std::size_t probes = 5000;
    std::size_t avatars = 2000;
};

/// What visitors of a campus ask of one mesh, by both trees and other people's engines; cases and queries:
/// `rays` (200 m) first_hit and any_hit, `probes` (rays of 5 m) first_hit, `avatars` touching, `points`
/// closest.
CaseResult run_campus_cases(const CampusSize& size, int rounds);

}  // namespace campuswalk::tools::bench
