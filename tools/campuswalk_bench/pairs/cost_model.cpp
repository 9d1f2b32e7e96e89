#include "tools/campuswalk_bench/pairs/cost_model.h"

#include <limits>

#include <Eigen/LU>

namespace campuswalk::tools::bench {

using collision::QueryStatistics;

namespace {

/// The costs selected by the bits of `which` that solve the normal equations; the others are 0.
Eigen::Vector3d solve(Eigen::Matrix3d normal, Eigen::Vector3d right, unsigned which) {
    for (int i = 0; i < 3; ++i) {
        if ((which >> static_cast<unsigned>(i) & 1U) == 0) {
            normal.col(i).setZero();
            normal.row(i) = Eigen::RowVector3d::Unit(i);
            right[i] = 0.0;
        }
    }
    return normal.fullPivLu().solve(right);
}

}  // namespace

double CostModel::predict(const QueryStatistics& work) const {
    return static_cast<double>(work.volume_tests) * cv + static_cast<double>(work.primitive_tests) * cp +
           static_cast<double>(work.transform_updates) * cu;
}

CostModel fit_costs(std::span<const QueryStatistics> work, std::span<const double> microseconds) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < work.size(); ++i) {
        const Eigen::Vector3d row = Eigen::Vector3d(static_cast<double>(work[i].volume_tests),
                                                    static_cast<double>(work[i].primitive_tests),
                                                    static_cast<double>(work[i].transform_updates)) /
                                    microseconds[i];
        normal += row * row.transpose();
        right += row;
    }
    // Tries all seven subsets of the three unknowns and takes the best solution without negative costs.
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (unsigned which = 1; which < 8; ++which) {
        const Eigen::Vector3d costs = solve(normal, right, which);
        // The sum of squares without its constant term.
        const double error = costs.dot(normal * costs) - 2.0 * costs.dot(right);
        if (costs.minCoeff() >= 0.0 && error < least) {
            best = costs;
            least = error;
        }
    }
    return {best[0], best[1], best[2]};
}

}  // namespace campuswalk::tools::bench
