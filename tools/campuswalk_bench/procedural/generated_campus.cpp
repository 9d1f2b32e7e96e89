#include "tools/campuswalk_bench/procedural/generated_campus.h"

#include <cmath>
#include <numbers>

#include "scene/model/mesh_parts.h"
#include "tools/campuswalk_bench/procedural/campus_parts.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::Pose;
using collision::Vec3;

namespace {

constexpr double kLot = kGeneratedLot;
constexpr int kCellsPerLot = 24;     ///< of the terrain, along a side
constexpr double kFoundation = 2.0;  ///< metres that a house extends into the ground, which isn't level
constexpr int kTrees = 14;           ///< per lot
constexpr int kBenches = 8;          ///< per lot
constexpr int kLamps = 6;            ///< per lot

struct House {
    Pose X_campus_house;  ///< at the centre of its floor
    double half_length = 0.0;
    double half_width = 0.0;
    int storeys = 0;

    bool is_within(double distance, double x, double z) const {
        const Vec3 local = X_campus_house.inverse_apply({x, 0.0, z});
        return std::abs(local.x()) < half_length + distance && std::abs(local.z()) < half_width + distance;
    }
};

void add_house(scene::MeshParts& parts, const House& house) {
    const auto wall = [&](int quarter, double half, double away) {
        const Pose X_house_wall = pose_with_yaw(Vec3::Zero(), 0.5 * std::numbers::pi * quarter);
        const Pose& X = house.X_campus_house;
        const Pose X_campus_wall{X.rotation * X_house_wall.rotation, X * X_house_wall.rotate({0, 0, away})};
        const auto at = [&](double x, double y) { return Vec3(X_campus_wall * Vec3(x, y, 0.0)); };
        parts.add_quad(at(-half, -kFoundation), at(half, -kFoundation), at(half, 0.0), at(-half, 0.0));
        add_window_wall(parts, X_campus_wall, half, house.storeys);
    };
    wall(0, house.half_length, house.half_width);
    wall(1, house.half_width, house.half_length);
    wall(2, house.half_length, house.half_width);
    wall(3, house.half_width, house.half_length);
    const double top = kStorey * house.storeys;
    const Vec3 eaves(house.half_length + 0.5, 0.2, house.half_width + 0.5);
    parts.add_box(house.X_campus_house, {0.0, top + eaves.y(), 0.0}, eaves);
}

/// One lot, centred at x, z.
class Lot {
public:
    Lot(double x, double z, SplitMix& random) : x_(x), z_(z), random_(random) {
        const double at_x = x + random.between(-6.0, 6.0);
        const double at_z = z + random.between(-6.0, 6.0);
        house_.X_campus_house =
            pose_with_yaw({at_x, rolling_ground(at_x, at_z), at_z}, random.between(-0.3, 0.3));
        house_.half_length = random.between(10.0, 14.0);
        house_.half_width = random.between(6.0, 9.0);
        house_.storeys = 3 + static_cast<int>(random.between(0.0, 4.0));
    }

    void add_to(GeneratedCampus& campus) {
        scene::MeshParts parts(campus.mesh);
        const auto begin = [&](CampusPart part) { begin_run(campus.runs, part, campus.mesh); };
        begin(CampusPart::building);
        add_house(parts, house_);
        begin(CampusPart::tree);
        for (int i = 0; i < kTrees; ++i) {
            add_tree(parts, outdoors(3.0), random_);
        }
        begin(CampusPart::bench);
        for (int i = 0; i < kBenches; ++i) {
            add_bench(parts, random_pose());
        }
        begin(CampusPart::lamp);
        for (int i = 0; i < kLamps; ++i) {
            add_lamp(parts, random_pose());
        }
    }

    /// The terrain's vertices outside of the house.
    void add_feet(std::vector<Vec3>& feet) const {
        for (int row = 0; row < kCellsPerLot; ++row) {
            for (int column = 0; column < kCellsPerLot; ++column) {
                const double x = x_ - 0.5 * kLot + kLot / kCellsPerLot * column;
                const double z = z_ - 0.5 * kLot + kLot / kCellsPerLot * row;
                if (!house_.is_within(1.0, x, z)) {
                    feet.emplace_back(x, rolling_ground(x, z), z);
                }
            }
        }
    }

private:
    Vec3 outdoors(double from_house) {
        while (true) {
            const double x = x_ + random_.between(-0.5 * kLot, 0.5 * kLot);
            const double z = z_ + random_.between(-0.5 * kLot, 0.5 * kLot);
            if (!house_.is_within(from_house, x, z)) {
                return {x, rolling_ground(x, z), z};
            }
        }
    }

    Pose random_pose() {
        const double yaw = random_.between(0.0, 6.0);
        return pose_with_yaw(outdoors(1.0), yaw);
    }

    double x_;
    double z_;
    SplitMix& random_;
    House house_;
};

}  // namespace

GeneratedCampus generated_campus(int lots) {
    GeneratedCampus campus;
    scene::MeshParts parts(campus.mesh);
    begin_run(campus.runs, CampusPart::terrain, campus.mesh);
    parts.add_terrain(lots * kCellsPerLot, -0.5 * lots * kLot, kLot / kCellsPerLot, rolling_ground);
    SplitMix random(1);
    for (int row = 0; row < lots; ++row) {
        for (int column = 0; column < lots; ++column) {
            Lot lot(kLot * (column - 0.5 * (lots - 1)), kLot * (row - 0.5 * (lots - 1)), random);
            lot.add_to(campus);
            lot.add_feet(campus.feet);
        }
    }
    return campus;
}

}  // namespace campuswalk::tools::bench
