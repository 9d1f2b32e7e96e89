#include "tools/campuswalk_bench/walk/walk_score.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::tools::bench {

using collision::Aabb;
using collision::Triangle;
using collision::Vec3;

namespace {

constexpr double kMaxColumns = 1024.0;  ///< per side

Aabb bounds_of(const Triangle& t) {
    return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

/// The distance between the segments from p to p + u and from q to q + v.
double distance_between_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
    const auto to_segment = [](const Vec3& point, const Vec3& from, const Vec3& along) {
        const double length = along.squaredNorm();
        const double t = length > 0.0 ? std::clamp(along.dot(point - from) / length, 0.0, 1.0) : 0.0;
        return (from + t * along - point).norm();
    };
    double least = std::min(
        {to_segment(p, q, v), to_segment(p + u, q, v), to_segment(q, p, u), to_segment(q + v, p, u)});
    const double uu = u.squaredNorm();
    const double uv = u.dot(v);
    const double vv = v.squaredNorm();
    const double determinant = uu * vv - uv * uv;
    if (determinant > 0.0) {
        const Vec3 r = q - p;
        const double s = (u.dot(r) * vv - v.dot(r) * uv) / determinant;
        const double t = (u.dot(r) * uv - v.dot(r) * uu) / determinant;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
            least = std::min(least, (p + s * u - q - t * v).norm());
        }
    }
    return least;
}

/// Whether `point`, which is in the triangle's plane, is inside the triangle or on its edge.
bool is_in(const Vec3& point, const Triangle& t, const Vec3& normal) {
    return normal.dot((t.b - t.a).cross(point - t.a)) >= 0.0 &&
           normal.dot((t.c - t.b).cross(point - t.b)) >= 0.0 &&
           normal.dot((t.a - t.c).cross(point - t.c)) >= 0.0;
}

bool is_through(const Vec3& from, const Vec3& to, const Triangle& t) {
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    const double above = normal.dot(from - t.a);
    const double below = normal.dot(to - t.a);
    if (above == below || (above > 0.0 && below > 0.0) || (above < 0.0 && below < 0.0)) {
        return false;
    }
    return is_in(from + above / (above - below) * (to - from), t, normal);
}

double distance(const Vec3& low, const Vec3& high, const Triangle& t) {
    if (is_through(low, high, t)) {
        return 0.0;
    }
    const Vec3 axis = high - low;
    double least = std::min({distance_between_segments(low, axis, t.a, t.b - t.a),
                             distance_between_segments(low, axis, t.b, t.c - t.b),
                             distance_between_segments(low, axis, t.c, t.a - t.c)});
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    const double area = normal.norm();
    for (const Vec3& end : {low, high}) {
        if (area > 0.0 && is_in(end, t, normal)) {
            least = std::min(least, std::abs(normal.dot(end - t.a)) / area);
        }
    }
    return least;
}

}  // namespace

WalkScorer::WalkScorer(const collision::TriangleMesh& mesh) : mesh_(mesh) {
    Aabb all;
    for (const Eigen::Vector3f& position : mesh.positions) {
        all.extend(position.cast<double>());
    }
    low_ = all.min;
    const double wide = std::max(all.max.x() - all.min.x(), all.max.z() - all.min.z());
    width_ = std::max(1.0, wide / kMaxColumns);
    side_ = static_cast<std::size_t>(wide / width_) + 1;
    first_.assign(side_ * side_ + 1, 0);
    const auto each_column = [&](const auto& visit) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const Columns over = columns_of(bounds_of(vertices(mesh, i)));
            for (std::size_t z = over.low_z; z <= over.high_z; ++z) {
                for (std::size_t x = over.low_x; x <= over.high_x; ++x) {
                    visit(z * side_ + x, i);
                }
            }
        }
    };
    each_column([&](std::size_t column, std::uint32_t) { ++first_[column + 1]; });
    for (std::size_t column = 1; column < first_.size(); ++column) {
        first_[column] += first_[column - 1];
    }
    triangles_.resize(first_.back());
    std::vector<std::uint32_t> next = first_;
    each_column([&](std::size_t column, std::uint32_t triangle) { triangles_[next[column]++] = triangle; });
}

WalkScorer::Columns WalkScorer::columns_of(const Aabb& box) const {
    const auto column = [&](double away) {
        return static_cast<std::size_t>(std::clamp(away / width_, 0.0, static_cast<double>(side_ - 1)));
    };
    return {column(box.min.x() - low_.x()), column(box.max.x() - low_.x()), column(box.min.z() - low_.z()),
            column(box.max.z() - low_.z())};
}

/// May visit a triangle more than once.
template <typename Visit>
void WalkScorer::visit_near(const Aabb& box, const Visit& visit) const {
    const Columns over = columns_of(box);
    for (std::size_t z = over.low_z; z <= over.high_z; ++z) {
        for (std::size_t x = over.low_x; x <= over.high_x; ++x) {
            const std::size_t column = z * side_ + x;
            for (std::uint32_t i = first_[column]; i < first_[column + 1]; ++i) {
                const Triangle t = vertices(mesh_, triangles_[i]);
                if (box.overlaps(bounds_of(t))) {
                    visit(t);
                }
            }
        }
    }
}

double WalkScorer::penetration(const Vec3& foot, double radius, double height) const {
    const Vec3 low = foot + Vec3(0.0, radius, 0.0);
    const Vec3 high = foot + Vec3(0.0, height - radius, 0.0);
    double deepest = 0.0;
    visit_near(Aabb{low, high}.grown(radius),
               [&](const Triangle& t) { deepest = std::max(deepest, radius - distance(low, high, t)); });
    return deepest;
}

bool WalkScorer::crosses(const Vec3& from, const Vec3& to) const {
    Aabb segment;
    segment.extend(from);
    segment.extend(to);
    bool crossed = false;
    visit_near(segment, [&](const Triangle& t) { crossed = crossed || is_through(from, to, t); });
    return crossed;
}

}  // namespace campuswalk::tools::bench
