#include "engine/events/gaze_memory.h"

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

using collision::ObjectId;

std::vector<ObjectId> objects(const GazeTracker& memory) {
    std::vector<ObjectId> ids;
    for (const GazeTracker::Look& look : memory.looks()) {
        ids.push_back(look.object);
    }
    return ids;
}

using Ids = std::vector<ObjectId>;
constexpr ObjectId kLibrary{3};
constexpr ObjectId kColumn{7};

TEST(GazeTracker, HoldsWhatPassesBehindAColumn) {
    GazeTracker memory(3);
    memory.meet(0, kLibrary, 9.0);
    memory.advance(0);
    memory.meet(1, kColumn, 2.0);
    memory.advance(1);
    EXPECT_EQ(objects(memory), Ids({kLibrary, kColumn}));
    memory.meet(2, kLibrary, 8.0);
    memory.advance(2);
    EXPECT_EQ(objects(memory), Ids({kLibrary, kColumn}));
    EXPECT_EQ(memory.distance(kLibrary), 8.0);
    EXPECT_EQ(memory.distance(kColumn), 2.0) << "as far away as it was";
}

TEST(GazeTracker, EndsALookInTheTickOfItsHold) {
    GazeTracker memory(3);
    memory.meet(10, kLibrary, 9.0);
    for (const Tick tick : {10, 11, 12}) {
        memory.advance(tick);
        EXPECT_EQ(objects(memory), Ids({kLibrary})) << tick;
    }
    memory.advance(13);
    EXPECT_EQ(objects(memory), Ids());
    EXPECT_EQ(memory.distance(kLibrary), 0.0);
}

TEST(GazeTracker, WithoutAHoldForgetsInTheNextTick) {
    for (const Tick hold : {0, 1}) {
        GazeTracker memory(hold);
        memory.meet(5, kLibrary, 9.0);
        memory.advance(5);
        EXPECT_EQ(objects(memory), Ids({kLibrary}));
        memory.advance(6);
        EXPECT_EQ(objects(memory), Ids());
    }
}

TEST(GazeTracker, ForgetsWhatItIsTold) {
    GazeTracker memory(100);
    memory.meet(0, kColumn, 1.0);
    memory.meet(0, kLibrary, 2.0);
    memory.forget(kColumn);
    EXPECT_EQ(objects(memory), Ids({kLibrary}));
    memory.forget_all();
    EXPECT_EQ(objects(memory), Ids());
}

}  // namespace
}  // namespace campuswalk::engine
