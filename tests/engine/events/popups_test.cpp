#include "engine/events/popups.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::engine {
namespace {

using Buildings = std::vector<std::size_t>;

/// Pop-ups without once, cooldown and dwell: only the number of touched objects matters.
class PlainPopups {
public:
    explicit PlainPopups(std::size_t buildings) : popups_(buildings) {}
    bool touch(std::size_t building) { return popups_.enter(building, 0, 0); }
    bool leave(std::size_t building) { return popups_.leave(building, 0, 0); }
    const Buildings& open() const { return popups_.open(); }

private:
    Popups popups_;
};

TEST(Popups, OpenWithTheFirstObjectAndCloseWithTheLast) {
    PlainPopups popups(2);
    EXPECT_TRUE(popups.open().empty());
    EXPECT_TRUE(popups.touch(1));
    EXPECT_FALSE(popups.touch(1)) << "a second object of an open building";
    EXPECT_EQ(popups.open(), Buildings({1}));
    EXPECT_FALSE(popups.leave(1));
    EXPECT_EQ(popups.open(), Buildings({1}));
    EXPECT_TRUE(popups.leave(1));
    EXPECT_TRUE(popups.open().empty());
    EXPECT_TRUE(popups.touch(1)) << "opens again";
}

TEST(Popups, AreListedOldestFirst) {
    PlainPopups popups(3);
    popups.touch(2);
    popups.touch(0);
    popups.touch(1);
    popups.touch(2);
    EXPECT_EQ(popups.open(), Buildings({2, 0, 1}));
    popups.leave(2);
    EXPECT_EQ(popups.open(), Buildings({2, 0, 1})) << "one of its objects is still touched";
    popups.leave(0);
    EXPECT_EQ(popups.open(), Buildings({2, 1}));
    popups.leave(2);
    popups.touch(2);
    EXPECT_EQ(popups.open(), Buildings({1, 2})) << "a reopened pop-up is the youngest";
}

/// The buildings of the touched objects, in the order in which they were touched.
class NaivePopups {
public:
    void touch(std::size_t building) { touched_.push_back(building); }
    void leave(std::size_t building) {
        // Any but the first: a pop-up is as old as the first contact with its building.
        const auto last = std::find(touched_.rbegin(), touched_.rend(), building);
        touched_.erase(std::next(last).base());
    }
    bool open(std::size_t building) const { return std::ranges::find(touched_, building) != touched_.end(); }
    Buildings all_open() const {
        Buildings open;
        for (const std::size_t building : touched_) {
            if (std::ranges::find(open, building) == open.end()) {
                open.push_back(building);
            }
        }
        return open;
    }
    const Buildings& touched() const { return touched_; }

private:
    Buildings touched_;
};

TEST(Popups, AgreeWithANaiveModelOnRandomSequences) {
    constexpr int kBuildings = 4;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(200)); ++seed) {
        support::Dice dice(seed);
        PlainPopups popups(kBuildings);
        NaivePopups naive;
        for (int i = 0; i < 200; ++i) {
            if (naive.touched().empty() || dice.chance(0.5)) {
                const auto building = static_cast<std::size_t>(dice.below(kBuildings));
                const bool opens = !naive.open(building);
                naive.touch(building);
                ASSERT_EQ(popups.touch(building), opens) << "seed " << seed << ", step " << i;
            } else {
                const auto which =
                    static_cast<std::size_t>(dice.below(static_cast<int>(naive.touched().size())));
                const std::size_t building = naive.touched()[which];
                naive.leave(building);
                ASSERT_EQ(popups.leave(building), !naive.open(building)) << "seed " << seed << ", step " << i;
            }
            ASSERT_EQ(popups.open(), naive.all_open()) << "seed " << seed << ", step " << i;
        }
    }
}

// ---- once, cooldown, dwell ------------------------------------------------------------------------------

constexpr std::size_t kDoor = 7;
constexpr std::size_t kRoom = 8;

TEST(Popups, OpenOnlyOnceIfConfiguredTo) {
    Popups popups(1);
    const PopupTiming once{true, 0, 0};
    EXPECT_TRUE(popups.enter(0, kDoor, 10, once));
    EXPECT_TRUE(popups.leave(0, kDoor, 20));
    EXPECT_FALSE(popups.enter(0, kDoor, 30, once));
    EXPECT_FALSE(popups.leave(0, kDoor, 40)) << "what isn't open doesn't close";
    EXPECT_TRUE(popups.enter(0, kRoom, 50)) << "another object may open it";
    EXPECT_EQ(popups.visits(0), 2);
}

TEST(Popups, CoolDownFromTheTimeTheyClose) {
    Popups popups(1);
    const PopupTiming timing{false, 10, 0};
    EXPECT_TRUE(popups.enter(0, kDoor, 100, timing));
    EXPECT_TRUE(popups.leave(0, kDoor, 120));
    EXPECT_FALSE(popups.enter(0, kDoor, 129, timing));
    EXPECT_TRUE(popups.open_due(135).empty()) << "a contact tries once only";
    EXPECT_FALSE(popups.leave(0, kDoor, 140));
    EXPECT_TRUE(popups.enter(0, kDoor, 130, timing)) << "ten ticks after it closed";
}

TEST(Popups, OpenAfterTheDwellTime) {
    Popups popups(2);
    const PopupTiming timing{false, 0, 5};
    EXPECT_FALSE(popups.enter(1, kDoor, 100, timing));
    EXPECT_TRUE(popups.open_due(104).empty());
    EXPECT_EQ(popups.open_due(105), Buildings({1}));
    EXPECT_EQ(popups.open(), Buildings({1}));
    EXPECT_TRUE(popups.open_due(106).empty()) << "only once";
    EXPECT_TRUE(popups.leave(1, kDoor, 107));
}

TEST(Popups, DoNotOpenIfTheContactEndsBeforeTheDwellTime) {
    Popups popups(1);
    const PopupTiming timing{false, 0, 5};
    popups.enter(0, kDoor, 100, timing);
    EXPECT_FALSE(popups.leave(0, kDoor, 104));
    popups.enter(0, kDoor, 104, timing);
    EXPECT_TRUE(popups.open_due(105).empty()) << "the dwell time starts again";
    EXPECT_EQ(popups.open_due(109), Buildings({0}));
}

TEST(Popups, OpenOnceForTwoObjectsWithDwellTime) {
    Popups popups(1);
    popups.enter(0, kDoor, 100, {false, 0, 5});
    popups.enter(0, kRoom, 100, {false, 0, 5});
    EXPECT_EQ(popups.open_due(105), Buildings({0}));
    EXPECT_EQ(popups.visits(0), 1);
    EXPECT_FALSE(popups.leave(0, kDoor, 106)) << "the room is still touched";
    EXPECT_TRUE(popups.leave(0, kRoom, 107));
}

}  // namespace
}  // namespace campuswalk::engine
