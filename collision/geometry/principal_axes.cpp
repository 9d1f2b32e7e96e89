#include "collision/geometry/principal_axes.h"

#include <cmath>
#include <utility>

namespace campuswalk::collision {

namespace {

/// Rotates columns p and q of `axes` so that `a`, the matrix in their frame, becomes 0 at (p, q).
void rotate(Mat3& a, Mat3& axes, int p, int q) {
    if (a(p, q) == 0.0) {
        return;
    }
    // The tangent of the smaller of the two possible angles; 0 where the quotient overflows.
    const double cotangent = (a(q, q) - a(p, p)) / (2.0 * a(p, q));
    const double root = std::sqrt(cotangent * cotangent + 1.0);
    const double t = 1.0 / (cotangent + std::copysign(root, cotangent));
    const double cos = 1.0 / std::sqrt(t * t + 1.0);
    const double sin = t * cos;

    const int other = 3 - p - q;
    const double to_p = a(other, p);
    const double to_q = a(other, q);
    a(p, p) -= t * a(p, q);
    a(q, q) += t * a(p, q);
    a(p, q) = a(q, p) = 0.0;
    a(other, p) = a(p, other) = cos * to_p - sin * to_q;
    a(other, q) = a(q, other) = sin * to_p + cos * to_q;
    for (int row = 0; row < 3; ++row) {
        const double x = axes(row, p);
        const double y = axes(row, q);
        axes(row, p) = cos * x - sin * y;
        axes(row, q) = sin * x + cos * y;
    }
}

/// Swaps two axes whose eigenvalues are out of order; `axes` remains a rotation.
void sort_pair(Mat3& a, Mat3& axes, int p, int q) {
    if (a(p, p) > a(q, q)) {
        std::swap(a(p, p), a(q, q));
        const Vec3 of_p = axes.col(p);
        axes.col(p) = axes.col(q);
        axes.col(q) = -of_p;
    }
}

}  // namespace

Mat3 principal_axes(const Mat3& symmetric) {
    constexpr double kNegligible = 1e-10;
    constexpr int kSweeps = 8;  // each squares the relative error: four nearly always suffice
    Mat3 a = symmetric;
    Mat3 axes = Mat3::Identity();
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        const double off_diagonal = std::abs(a(0, 1)) + (std::abs(a(0, 2)) + std::abs(a(1, 2)));
        if (off_diagonal <= kNegligible * (std::abs(a(0, 0)) + (std::abs(a(1, 1)) + std::abs(a(2, 2))))) {
            break;
        }
        rotate(a, axes, 0, 1);
        rotate(a, axes, 0, 2);
        rotate(a, axes, 1, 2);
    }
    sort_pair(a, axes, 0, 1);
    sort_pair(a, axes, 1, 2);
    sort_pair(a, axes, 0, 1);
    return axes;
}

}  // namespace campuswalk::collision
