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

    /// A wedge from y = 0 at `foot_z` up to `height` at `top_z`, where it is open.
    void add_ramp(double low_x, double high_x, double foot_z, double top_z, double height) const {
        // Looking up the slope.
        const double left = foot_z > top_z ? low_x : high_x;
        const double right = foot_z > top_z ? high_x : low_x;
        const auto vertex = [&](double x, double y, double z) {
            return parts.add_point(X * collision::Vec3(x, y, z));
        };
        const std::uint32_t a = vertex(left, 0.0, foot_z);
        const std::uint32_t b = vertex(right, 0.0, foot_z);
        const std::uint32_t c = vertex(right, height, top_z);
        const std::uint32_t d = vertex(left, height, top_z);
        parts.add_quad(a, b, c, d);
        parts.add_triangle(a, d, vertex(left, 0.0, top_z));
        parts.add_triangle(b, vertex(right, 0.0, top_z), c);
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
