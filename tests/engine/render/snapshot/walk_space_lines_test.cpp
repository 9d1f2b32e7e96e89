#include "engine/render/snapshot/walk_space_lines.h"

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"

namespace campuswalk::engine::render {
namespace {

using Eigen::Vector3d;

/// With a pillar of 1 m x 1 m in the middle.
scene::Campus yard_with_pillar() {
    scene::Campus campus = walled_yard();
    add_box(campus, "pillar", {-0.5, 0, -0.5}, {0.5, 4, 0.5});
    return campus;
}

double length_of(const std::vector<OverlayLine>& lines, double at_least) {
    double length = 0.0;
    for (const OverlayLine& line : lines) {
        const double own = (line.b - line.a).norm();
        length += own >= at_least ? own : 0.0;
    }
    return length;
}

std::vector<OverlayLine> lines_in(const scene::Campus& campus, const WalkSpaceRequest& request) {
    std::vector<OverlayLine> lines;
    add_walk_space(campus, request, lines);
    return lines;
}

TEST(WalkSpaceLines, FollowTheWalls) {
    const scene::Campus campus = yard_with_pillar();
    const std::vector<OverlayLine> lines = lines_in(campus, {{}, {{3, 0, 3}}});
    for (const OverlayLine& line : lines) {
        for (const Vector3d& p : {line.a, line.b}) {
            EXPECT_LE(p.cwiseAbs().maxCoeff(), 6.0);
            EXPECT_GE(std::max(std::abs(p.x()), std::abs(p.z())), 0.5);
        }
    }
    // Of the body's middle, to within a cell: a square of 11.4 m around one of 1.6 m with round vertices.
    EXPECT_NEAR(length_of(lines, 0.2), 4 * 11.4 + 4 * 1.6, 4.0);
}

TEST(WalkSpaceLines, EndAtTheRadius) {
    const scene::Campus campus = yard_with_pillar();
    const std::vector<OverlayLine> lines = lines_in(campus, {{}, {{3, 0, 3}}, 2.0});
    EXPECT_NEAR(length_of(lines, 0.2), 4 * 4.0, 2.0);
    for (const OverlayLine& line : lines) {
        EXPECT_LE((line.a - Vector3d(3, 0, 3)).cwiseAbs().maxCoeff(), 2.5);
    }
}

TEST(WalkSpaceLines, LeadWhereADisabledObjectStood) {
    const scene::Campus campus = yard_with_pillar();
    std::vector<bool> disabled(campus.objects.size(), false);
    disabled.back() = true;
    const std::vector<OverlayLine> lines = lines_in(campus, {{}, {{3, 0, 3}}, 0.0, &disabled});
    EXPECT_NEAR(length_of(lines, 0.2), 4 * 11.4, 3.0);
}

}  // namespace
}  // namespace campuswalk::engine::render
