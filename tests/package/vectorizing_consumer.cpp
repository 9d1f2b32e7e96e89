// A program that lets Eigen vectorize, which the library is built without: neither may change what the other
// computes.
#include <cstdio>

#include "collision/geometry/closest.h"

#ifndef EIGEN_VECTORIZE
#error "the library's own setting of Eigen has leaked, or this processor has no vector unit"
#endif

using namespace campuswalk::collision;

int main() {
    // x + (y + z) is 1 + 2^-52, (x + y) + z is 1.
    const Vec3 point(1.0, 0x1p-53, 0x1p-53);
    const double own_sum = point.dot(Vec3::Ones());
    const Vec3 nearest = closest_on_segment({Vec3::Zero(), Vec3::Ones()}, point);
    std::printf("the consumer adds %s, the library %s\n", own_sum == 1.0 ? "(x + y) + z" : "x + (y + z)",
                nearest.x() == 1.0 / 3.0 ? "(x + y) + z" : "x + (y + z)");
}
