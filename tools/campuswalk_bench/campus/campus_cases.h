#pragma once

#include <cstddef>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

struct CampusSize {
    int lots = 8;  ///< per side, see generated_campus.h
    std::size_t rays = 5000;
    std::size_t probes = 5000;
    std::size_t avatars = 2000;
};

/// The queries that visitors of a campus cause on one mesh, by both trees and by peers' engines. Cases and
/// queries: `rays` (200 m) first_hit and any_hit, `probes` (rays of 5 m) first_hit, `avatars` touching,
/// `points` closest.
CaseResult run_campus_cases(const CampusSize& size, int rounds);

}  // namespace campuswalk::tools::bench
