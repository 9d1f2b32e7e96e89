// How wide passages are, by which plans are coloured.

#include "engine/walkspace/passage/passage_widths.h"

#include <optional>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "engine/walkspace/space/node_numbers.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"

namespace campuswalk::engine {
namespace {

/// Two rooms with a passage of this width and of 2 m length between them, its ground 0.2 m higher.
scene::Campus rooms_with_passage(double width) {
    scene::Campus campus = walled_yard();
    add_box(campus, "left", {-1, 0, -6}, {1, 3, -0.5 * width});
    add_box(campus, "right", {-1, 0, 0.5 * width}, {1, 3, 6});
    add_box(campus, "sill", {-1, -0.1, -6}, {1, 0.2, 6});
    return campus;
}

class PassageWidths : public testing::Test {
protected:
    void measure(const scene::Campus& campus, double widest, std::size_t workers = 1) {
        const WorkerWorlds worlds(campus.world, workers, collision::make_bullet_broad_phase);
        const ExploreSettings settings = explore_from({3, 0, 0});
        space_.emplace(explored(campus.world, settings));
        widths_ = passage_widths(worlds, settings, *space_, widest);
    }
    double at(double x, double y, double z) const {
        const auto node = space_->find(space_->grid.cell_at(x, z), y, 0.2);
        return node ? static_cast<double>(widths_[NodeNumbers(*space_)(*node)]) : -1.0;
    }

    std::optional<WalkSpace> space_;
    std::vector<float> widths_;
};

TEST_F(PassageWidths, AreThoseOfTheWallsBeside) {
    for (const double width : {0.7, 0.95, 1.1, 1.4}) {
        measure(rooms_with_passage(width), 1.6);
        EXPECT_NEAR(at(0.1, 0.2, 0.1), width, 0.02) << "in the passage";
        EXPECT_NEAR(at(-3.1, 0.0, 0.1), 1.6, 1e-6) << "beyond it, as wide as is asked for";
        EXPECT_NEAR(at(3.1, 0.0, 5.6), 1.6, 1e-6) << "beside a wall";
        EXPECT_NEAR(at(5.6, 0.0, 5.6), 1.6, 1e-6) << "in a corner";
    }
}

TEST_F(PassageWidths, AreThoseOfDoorsInThinWalls) {
    scene::Campus campus = walled_yard();
    add_box(campus, "left", {-0.05, 0, -6}, {0.05, 3, -0.5});
    add_box(campus, "right", {-0.05, 0, 0.5}, {0.05, 3, 6});
    measure(campus, 1.6);
    EXPECT_NEAR(at(0.1, 0.0, 0.1), 1.0, 0.1);
    EXPECT_NEAR(at(0.9, 0.0, 0.1), 1.6, 1e-6) << "before it";
}

TEST_F(PassageWidths, AreTheSameForAnyNumberOfWorkers) {
    measure(rooms_with_passage(1.0), 1.6);
    const std::vector<float> alone = widths_;
    measure(rooms_with_passage(1.0), 1.6, 3);
    EXPECT_EQ(widths_, alone);
}

TEST_F(PassageWidths, TakeNoNoticeOfSteps) {
    scene::Campus campus = walled_yard();
    for (int i = 1; i <= 8; ++i) {
        add_box(campus, "tread-" + std::to_string(i), {-3, -0.1, 3.0 - 0.3 * i},
                {1, 0.17 * i, 3.3 - 0.3 * i});
    }
    measure(campus, 1.2);
    for (int i = 1; i <= 7; ++i) {
        EXPECT_NEAR(at(-1.1, 0.17 * i, 3.15 - 0.3 * i), 1.2, 0.01) << i;
    }
}

}  // namespace
}  // namespace campuswalk::engine
