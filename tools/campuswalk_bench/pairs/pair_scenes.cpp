#include "tools/campuswalk_bench/pairs/pair_scenes.h"

#include "collision/geometry/trigonometry.h"
#include "tools/campuswalk_bench/procedural/cylinder.h"
#include "tools/campuswalk_bench/procedural/table1_scene.h"
#include "tools/campuswalk_bench/procedural/teapot.h"

namespace campuswalk::tools::bench {

PairScene table1_pair_scene() {
    const Table1Scene table = table1_scene();
    PairScene made{"table1", table.cylinder, table.teapot, {}};
    for (const Table1Placement& placement : table.placements) {
        made.placements.push_back({placement.X_cylinder_teapot, placement.pairs});
    }
    return made;
}

PairScene finer_scene(int fineness) {
    constexpr std::uint32_t kPairs = 666;
    CylinderShape shape;
    shape.sides *= fineness;
    shape.stacks *= fineness;
    PairScene made{"million", cylinder(shape), teapot(fineness), {}};
    for (const Table1Placement& placement : table1_scene().placements) {
        if (placement.pairs == kPairs) {
            made.placements.push_back({placement.X_cylinder_teapot, std::nullopt});
        }
    }
    return made;
}

PairScene nested_scene() {
    constexpr double kHalfTurn = 3.141592653589793;
    const CylinderShape outer;
    CylinderShape inner = outer;
    // The middle of a side is nearer to the axis than its edges are.
    inner.radius = outer.radius * collision::sin_cos(kHalfTurn / outer.sides).cos - kNestedGap;
    inner.height = outer.height - 2.0 * kNestedGap;
    const auto [sin, cos] = collision::sin_cos(1.1 * kHalfTurn / outer.sides);
    PairPlacement placement;
    placement.X_a_b.rotation << cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0;
    placement.pairs = 0;
    return {"nested", cylinder(outer), cylinder(inner), {placement}};
}

}  // namespace campuswalk::tools::bench
