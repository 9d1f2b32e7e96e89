#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "tools/campuswalk_bench/procedural/walk_course.h"

namespace campuswalk::tools::bench {

/// Builds a course in its own frame, where the ground is y = 0.
struct CourseGround {
    scene::MeshParts& parts;
    const collision::Pose& X;
    const CourseSizes& sizes;
    std::vector<WalkPath>& paths;

    void add_box(const collision::Vec3& low, const collision::Vec3& high) const {
        parts.add_box(X, 0.5 * (low + high), 0.5 * (high - low));
    }

    /// A wedge from its corner `foot`, where it is lowest, to the one across, where it is highest and open;
    /// foot.x < top.x.
    void add_ramp(const collision::Vec3& foot, const collision::Vec3& top) const {
        const bool towards_north = foot.z() > top.z();
        const double left = towards_north ? foot.x() : top.x();  // looking up the slope
        const double right = towards_north ? top.x() : foot.x();
        const auto vertex = [&](double x, double y, double z) {
            return parts.add_point(X * collision::Vec3(x, y, z));
        };
        const std::uint32_t a = vertex(left, foot.y(), foot.z());
        const std::uint32_t b = vertex(right, foot.y(), foot.z());
        const std::uint32_t c = vertex(right, top.y(), top.z());
        const std::uint32_t d = vertex(left, top.y(), top.z());
        parts.add_quad(a, b, c, d);
        parts.add_triangle(a, d, vertex(left, foot.y(), top.z()));
        parts.add_triangle(b, vertex(right, foot.y(), top.z()), c);
    }

    void add_path(const char* name, const collision::Vec3& start,
                  std::initializer_list<collision::Vec3> goals, bool forbidden = false) const {
        WalkPath path{name, X * start, {}};
        for (const collision::Vec3& at : goals) {
            path.goals.push_back({X * at, forbidden});
        }
        paths.push_back(path);
    }
};

// The three parts of a course.
void add_hall(const CourseGround& ground);
void add_yard(const CourseGround& ground);
void add_pens(const CourseGround& ground);

}  // namespace campuswalk::tools::bench
