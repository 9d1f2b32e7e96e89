#pragma once

#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "scene/procedural/mesh_parts.h"

namespace campuswalk::scene {

/// A place to be walked to.
struct WalkGoal {
    collision::Vec3 at = collision::Vec3::Zero();  ///< the foot's
    bool forbidden = false;                        ///< there is no way to it for a person
};

/// From its start to one goal after the other, straight ahead. Whoever slides along what stands in the way
/// gets to those that aren't forbidden.
struct WalkPath {
    std::string name;
    collision::Vec3 start = collision::Vec3::Zero();  ///< the foot's, on the ground
    std::vector<WalkGoal> goals;
};

/// What differs between courses, metres and degrees. It is made for a person 1.8 m high and 0.6 m wide who
/// climbs 0.3 m and slopes of 50 degrees.
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

/// One of nine that go through what each size may be, from easy to hard.
CourseSizes course_sizes(int ninth);

/// Of the level ground that a course needs, metres.
constexpr double kCourseRadius = 24.0;

/// Puts a course's buildings on level ground about X's origin, and appends its paths: in and out of doors, up
/// and down stairs, ramps, kerbs and a drop, along walls and around a post; and to places behind walls, up a
/// riser or slope, through a gap, an opening or bars that are too much.
void add_course(MeshParts& parts, const collision::Pose& X_campus_course, const CourseSizes& sizes,
                std::vector<WalkPath>& paths);

}  // namespace campuswalk::scene
