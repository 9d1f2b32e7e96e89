#include "tools/campuswalk_bench/procedural/walk_course.h"

#include "tools/campuswalk_bench/procedural/course_ground.h"

namespace campuswalk::tools::bench {

CourseSizes course_sizes(int difficulty) {
    constexpr double kThick[] = {0.2, 0.02, 0.0};
    CourseSizes sizes;
    sizes.door = 1.1 - 0.03 * difficulty;
    sizes.gate = 2.0 - 0.015 * difficulty;
    sizes.kerb = 0.1 + 0.0225 * difficulty;
    sizes.ramp = 15.0 + 4.0 * difficulty;
    sizes.wall = kThick[difficulty % 3];
    sizes.too_high = 0.47 - 0.02 * difficulty;
    sizes.too_steep = 65.0 - 1.5 * difficulty;
    sizes.too_narrow = 0.37 + 0.02 * difficulty;
    sizes.too_low = 1.38 + 0.05 * difficulty;
    sizes.storeys_above_ground = 2 + difficulty % 3;
    return sizes;
}

void add_course(scene::MeshParts& parts, const collision::Pose& X_campus_course, const CourseSizes& sizes,
                std::vector<WalkPath>& paths) {
    const CourseGround ground{parts, X_campus_course, sizes, paths};
    add_hall(ground);
    add_yard(ground);
    add_pens(ground);
}

}  // namespace campuswalk::tools::bench
