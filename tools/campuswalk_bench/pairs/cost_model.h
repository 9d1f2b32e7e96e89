#pragma once

#include <span>

#include "collision/base/query_statistics.h"

namespace campuswalk::tools::bench {

/// The paper's eq. (4), T = Nv Cv + Np Cp + Nu Cu: what a test of two volumes, a test of two triangles and a
/// node's move cost. Microseconds each.
struct CostModel {
    double cv = 0.0;
    double cp = 0.0;
    double cu = 0.0;

    double predict(const collision::QueryStatistics& work) const;
};

/// The costs, none of them negative, that are nearest to measured times: the least sum of squares of relative
/// errors, since otherwise the longest query alone would decide. A time for each work, at least three.
CostModel fit_costs(std::span<const collision::QueryStatistics> work, std::span<const double> microseconds);

}  // namespace campuswalk::tools::bench
