#include "tools/campuswalk_bench/procedural/walkable_campus.h"

#include <algorithm>
#include <cmath>

#include "scene/model/mesh_parts.h"
#include "tools/campuswalk_bench/procedural/campus_parts.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::Pose;
using collision::Vec3;

namespace {

constexpr double kLot = kWalkableLot;
constexpr int kCellsPerLot = 36;            ///< of the terrain, along a side
constexpr double kLevel = 26.0;             ///< radius of the level ground, metres: the course and one cell
constexpr double kSlope = 10.0;             ///< metres from there to the full height of the hills
constexpr double kTreeLine = kLevel + 3.5;  ///< a crown's radius away from the course
constexpr int kTrees = 7;                   ///< per lot
constexpr int kBenches = 6;                 ///< per lot
constexpr int kLamps = 6;                   ///< per lot
static_assert(kLevel >= kCourseRadius + kLot / kCellsPerLot);

double hills(double x, double z) {
    return 0.5 * rolling_ground(x, z);
}

double center_of(int lot, int lots) {
    return kLot * (lot - 0.5 * (lots - 1));
}

/// The centre of the lot at the coordinate.
double nearest_center(double coordinate, int lots) {
    const auto lot = static_cast<int>(coordinate / kLot + 0.5 * lots);
    return center_of(std::clamp(lot, 0, lots - 1), lots);
}

/// The height of a vertex of the terrain.
double vertex_height(double x, double z, int lots) {
    const double center_x = nearest_center(x, lots);
    const double center_z = nearest_center(z, lots);
    const double out = Vec3(x - center_x, 0.0, z - center_z).norm();
    const double t = std::clamp((out - kLevel) / kSlope, 0.0, 1.0);
    const double smooth = t * t * (3.0 - 2.0 * t);
    return (1.0 - smooth) * hills(center_x, center_z) + smooth * hills(x, z);
}

/// The height interpolated on the terrain's triangles.
double ground_height(double x, double z, int lots) {
    constexpr double kCell = kLot / kCellsPerLot;
    const double low = -0.5 * lots * kLot;
    const double column = std::floor((x - low) / kCell);
    const double row = std::floor((z - low) / kCell);
    const auto height = [&](double across, double along) {
        return vertex_height(low + kCell * (column + across), low + kCell * (row + along), lots);
    };
    const double u = (x - low) / kCell - column;
    const double v = (z - low) / kCell - row;
    // The triangles of a cell share the diagonal from its first vertex.
    const double first = height(0.0, 0.0);
    const double last = height(1.0, 1.0);
    if (v >= u) {
        const double beside = height(0.0, 1.0);
        return first + v * (beside - first) + u * (last - beside);
    }
    const double beside = height(1.0, 0.0);
    return first + u * (beside - first) + v * (last - beside);
}

/// One lot of the campus.
class Lot {
public:
    Lot(int row, int column, int lots, SplitMix& random) : lots_(lots), random_(random) {
        const double x = center_of(column, lots);
        const double z = center_of(row, lots);
        X_campus_course_ = pose_with_yaw({x, ground_height(x, z, lots), z}, random.between(-3.0, 3.0));
        sizes_ = course_sizes(row % 3 * 3 + column % 3);
    }

    void build(WalkableCampus& campus, std::vector<WalkPath>& paths) {
        scene::MeshParts parts(campus.mesh);
        const auto begin = [&](CampusPart part) { begin_run(campus.runs, part, campus.mesh); };
        begin(CampusPart::building);
        add_course(parts, X_campus_course_, sizes_, paths);
        paths.push_back(over_the_hill());
        begin(CampusPart::tree);
        for (int i = 0; i < kTrees; ++i) {
            add_tree(parts, around(kTreeLine), random_);
        }
        begin(CampusPart::bench);
        for (int i = 0; i < kBenches; ++i) {
            const Vec3 at = around(kLevel + 1.0);
            add_bench(parts, pose_with_yaw(at, random_.between(0.0, 6.0)));
        }
        begin(CampusPart::lamp);
        for (int i = 0; i < kLamps; ++i) {
            const Vec3 at = around(kLevel + 1.0);
            add_lamp(parts, pose_with_yaw(at, random_.between(0.0, 6.0)));
        }
    }

private:
    Vec3 on_ground(const Vec3& in_course) const {
        const Vec3 at = X_campus_course_ * in_course;
        return {at.x(), ground_height(at.x(), at.z(), lots_), at.z()};
    }

    /// Up the slope around the course and back. Nothing else is placed near x > 0, z = 0.
    WalkPath over_the_hill() const {
        return {
            "hill",
            on_ground({21.0, 0.0, 1.0}),
            {{on_ground({27.0, 0.0, 0.5})}, {on_ground({33.0, 0.0, 0.0})}, {on_ground({21.0, 0.0, -1.0})}}};
    }

    /// A random place on the lot, at least `away` from its centre, and where a crown would not obstruct the
    /// next lot.
    Vec3 around(double away) {
        constexpr double kFree = 5.0;
        constexpr double kFar = 0.5 * kLot - 4.0;
        while (true) {
            const Vec3 offset(random_.between(-kFar, kFar), 0.0, random_.between(-kFar, kFar));
            const Vec3 in_course = X_campus_course_.inverse_rotate(offset);
            const bool is_on_path = in_course.x() > 0.0 && std::abs(in_course.z()) < kFree;
            if (offset.norm() >= away && !is_on_path) {
                return on_ground(in_course);
            }
        }
    }

    int lots_;
    SplitMix& random_;
    Pose X_campus_course_;
    CourseSizes sizes_;
};

/// Selects three lots per side, spread from end to end, with remainders 0, 1 and 2 modulo 3: nine sizes of
/// courses.
bool is_walked(int lot, int lots) {
    if (lots < 3) {
        return true;
    }
    const int center = (lots / 2 + 1) / 3 * 3 + 1;
    const int last = (lots - 3) / 3 * 3 + 2;
    return lot == 0 || lot == std::min(center, last - 1) || lot == last;
}

}  // namespace

WalkableCampus walkable_campus(int lots) {
    WalkableCampus campus;
    scene::MeshParts parts(campus.mesh);
    begin_run(campus.runs, CampusPart::terrain, campus.mesh);
    parts.add_terrain(lots * kCellsPerLot, -0.5 * lots * kLot, kLot / kCellsPerLot,
                      [&](double x, double z) { return vertex_height(x, z, lots); });
    SplitMix random(4);
    std::vector<WalkPath> unused;
    for (int row = 0; row < lots; ++row) {
        for (int column = 0; column < lots; ++column) {
            const bool walked = is_walked(row, lots) && is_walked(column, lots);
            Lot(row, column, lots, random).build(campus, walked ? campus.paths : unused);
        }
    }
    return campus;
}

}  // namespace campuswalk::tools::bench
