#pragma once

#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "scene/model/mesh_parts.h"

namespace campuswalk::tools::bench {

/// A position to walk to.
struct WalkGoal {
    collision::Vec3 at = collision::Vec3::Zero();  ///< of the foot
    bool forbidden = false;                        ///< unreachable for a person
};

/// Straight segments from the start to one goal after the other. An avatar that slides along obstacles
/// reaches all goals that aren't forbidden.
struct WalkPath {
    std::string name;
    collision::Vec3 start = collision::Vec3::Zero();  ///< of the foot, on the ground
    std::vector<WalkGoal> goals;
};

/// The sizes of a course's obstacles, metres and degrees, for an avatar that is 1.8 m high and 0.6 m wide and
/// climbs steps of 0.3 m and slopes of 50 degrees.
struct CourseSizes {
    double door = 0.85;            ///< wide
    double gate = 1.95;            ///< high
    double kerb = 0.10;            ///< high
    double ramp = 15.0;            ///< degrees
    double wall = 0.2;             ///< thick; 0: one quad
    double too_high = 0.31;        ///< a riser
    double too_steep = 53.0;       ///< degrees
    double too_narrow = 0.53;      ///< a gap
    double too_low = 1.78;         ///< an opening
    int storeys_above_ground = 2;  ///< of the hall
};

/// `difficulty`: 0 to 8.
CourseSizes course_sizes(int difficulty);

/// The radius of the level ground that a course needs, metres.
constexpr double kCourseRadius = 24.0;

/// Adds a course on level ground around X's origin and appends its paths: through doors, up and down stairs,
/// ramps, kerbs and a drop, along walls and around a post; and to forbidden goals behind walls, risers,
/// slopes, gaps, openings and bars that can't be passed.
void add_course(scene::MeshParts& parts, const collision::Pose& X_campus_course, const CourseSizes& sizes,
                std::vector<WalkPath>& paths);

}  // namespace campuswalk::tools::bench
