#include "engine/events/gaze_tracker.h"

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

using collision::ObjectId;

std::vector<ObjectId> objects(const GazeTracker& tracker) {
    std::vector<ObjectId> ids;
    for (const GazeTracker::Look& look : tracker.looks()) {
        ids.push_back(look.object);
    }
    return ids;
}

using Ids = std::vector<ObjectId>;
constexpr ObjectId kLibrary{3};
constexpr ObjectId kColumn{7};

TEST(GazeTracker, KeepsAnObjectThatPassesBehindAColumn) {
    GazeTracker tracker(3);
    tracker.hit(0, kLibrary, 9.0);
    tracker.advance(0);
    tracker.hit(1, kColumn, 2.0);
    tracker.advance(1);
    EXPECT_EQ(objects(tracker), Ids({kLibrary, kColumn}));
    tracker.hit(2, kLibrary, 8.0);
    tracker.advance(2);
    EXPECT_EQ(objects(tracker), Ids({kLibrary, kColumn}));
    EXPECT_EQ(tracker.distance(kLibrary), 8.0);
    EXPECT_EQ(tracker.distance(kColumn), 2.0) << "the distance of the last hit";
}

TEST(GazeTracker, EndsALookWhenItsHoldTimeIsOver) {
    GazeTracker tracker(3);
    tracker.hit(10, kLibrary, 9.0);
    for (const Tick tick : {10, 11, 12}) {
        tracker.advance(tick);
        EXPECT_EQ(objects(tracker), Ids({kLibrary})) << tick;
    }
    tracker.advance(13);
    EXPECT_EQ(objects(tracker), Ids());
    EXPECT_EQ(tracker.distance(kLibrary), 0.0);
}

TEST(GazeTracker, ForgetsInTheNextTickWithoutHoldTime) {
    for (const Tick hold : {0, 1}) {
        GazeTracker tracker(hold);
        tracker.hit(5, kLibrary, 9.0);
        tracker.advance(5);
        EXPECT_EQ(objects(tracker), Ids({kLibrary}));
        tracker.advance(6);
        EXPECT_EQ(objects(tracker), Ids());
    }
}

TEST(GazeTracker, ForgetsObjectsOnRequest) {
    GazeTracker tracker(100);
    tracker.hit(0, kColumn, 1.0);
    tracker.hit(0, kLibrary, 2.0);
    tracker.forget(kColumn);
    EXPECT_EQ(objects(tracker), Ids({kLibrary}));
    tracker.forget_all();
    EXPECT_EQ(objects(tracker), Ids());
}

}  // namespace
}  // namespace campuswalk::engine
