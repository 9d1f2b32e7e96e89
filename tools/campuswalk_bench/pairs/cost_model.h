#pragma once

#include <span>

#include "collision/base/query_statistics.h"

namespace campuswalk::tools::bench {

/// The paper's eq. (4), T = Nv Cv + Np Cp + Nu Cu: the costs of a test of two volumes, of a test of two
/// triangles and of a node's update, in microseconds.
struct CostModel {
    double cv = 0.0;
    double cp = 0.0;
    double cu = 0.0;

    double predict(const collision::QueryStatistics& work) const;
};

/// The non-negative costs that fit the measured times best: the least sum of squares of relative errors,
/// since otherwise the longest query would dominate. One time per work, at least three.
CostModel fit_costs(std::span<const collision::QueryStatistics> work, std::span<const double> microseconds);

}  // namespace campuswalk::tools::bench
