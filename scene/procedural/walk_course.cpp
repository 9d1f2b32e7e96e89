#include "scene/procedural/walk_course.h"

#include "scene/procedural/course_ground.h"

namespace campuswalk::scene {

CourseSizes course_sizes(int ninth) {
    constexpr double kThick[] = {0.2, 0.02, 0.0};
    CourseSizes sizes;
    sizes.door = 1.1 - 0.03 * ninth;
    sizes.gate = 2.0 - 0.015 * ninth;
    sizes.kerb = 0.1 + 0.0225 * ninth;
    sizes.ramp = 15.0 + 4.0 * ninth;
    sizes.wall = kThick[ninth % 3];
    sizes.too_high = 0.47 - 0.02 * ninth;
    sizes.too_steep = 65.0 - 1.5 * ninth;
    sizes.too_narrow = 0.37 + 0.02 * ninth;
    sizes.too_low = 1.38 + 0.05 * ninth;
    sizes.storeys_above_ground = 2 + ninth % 3;
    return sizes;
}

void add_course(MeshParts& parts, const collision::Pose& X_campus_course, const CourseSizes& sizes,
                std::vector<WalkPath>& paths) {
    const CourseGround ground{parts, X_campus_course, sizes, paths};
    add_hall(ground);
    add_yard(ground);
    add_pens(ground);
}

}  // namespace campuswalk::scene
