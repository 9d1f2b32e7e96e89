#include "tools/campuswalk/bench/cost_model.h"

#include <limits>

#include <Eigen/Dense>

namespace campuswalk::tools::bench {

using collision::QueryCounters;

namespace {

/// Least squares with the costs in `which` (a bit each) free and the others 0.
Eigen::Vector3d solve(const Eigen::MatrixX3d& rows, const Eigen::VectorXd& right, unsigned which) {
    Eigen::MatrixX3d free = rows;
    for (int i = 0; i < 3; ++i) {
        if ((which >> static_cast<unsigned>(i) & 1U) == 0) {
            free.col(i).setZero();
        }
    }
    return free.completeOrthogonalDecomposition().solve(right);
}

}  // namespace

double CostModel::predict(const QueryCounters& work) const {
    return static_cast<double>(work.nv) * cv + static_cast<double>(work.np) * cp +
           static_cast<double>(work.nu) * cu;
}

CostModel fit_costs(std::span<const QueryCounters> work, std::span<const double> microseconds) {
    const auto count = static_cast<Eigen::Index>(work.size());
    Eigen::MatrixX3d rows(count, 3);
    for (std::size_t i = 0; i < work.size(); ++i) {
        rows.row(static_cast<Eigen::Index>(i)) =
            Eigen::RowVector3d(static_cast<double>(work[i].nv), static_cast<double>(work[i].np),
                               static_cast<double>(work[i].nu)) /
            microseconds[i];
    }
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
    // Of three unknowns all seven ways to leave some out can be tried: the best that is nowhere negative.
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (unsigned which = 1; which < 8; ++which) {
        const Eigen::Vector3d costs = solve(rows, ones, which);
        const double error = (rows * costs - ones).squaredNorm();
        if (costs.minCoeff() >= 0.0 && error < least) {
            best = costs;
            least = error;
        }
    }
    return {best[0], best[1], best[2]};
}

}  // namespace campuswalk::tools::bench
