#include "engine/events/popups.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::engine {
namespace {

using Buildings = std::vector<std::size_t>;

/// Windows that open at once: what matters is how many objects are met.
class PlainPopups {
public:
    explicit PlainPopups(std::size_t buildings) : popups_(buildings) {}
    bool meet(std::size_t building) { return popups_.meet(building, 0, 0); }
    bool leave(std::size_t building) { return popups_.leave(building, 0, 0); }
    const Buildings& open() const { return popups_.open(); }

private:
    Popups popups_;
};

TEST(Popups, OpenWithTheFirstObjectAndCloseWithTheLast) {
    PlainPopups popups(2);
    EXPECT_TRUE(popups.open().empty());
    EXPECT_TRUE(popups.meet(1));
    EXPECT_FALSE(popups.meet(1)) << "a second object of an open building";
    EXPECT_EQ(popups.open(), Buildings({1}));
    EXPECT_FALSE(popups.leave(1));
    EXPECT_EQ(popups.open(), Buildings({1}));
    EXPECT_TRUE(popups.leave(1));
    EXPECT_TRUE(popups.open().empty());
    EXPECT_TRUE(popups.meet(1)) << "and opens again";
}

TEST(Popups, ListTheOldestFirst) {
    PlainPopups popups(3);
    popups.meet(2);
    popups.meet(0);
    popups.meet(1);
    popups.meet(2);
    EXPECT_EQ(popups.open(), Buildings({2, 0, 1}));
    popups.leave(2);
    EXPECT_EQ(popups.open(), Buildings({2, 0, 1})) << "one of its objects is still met";
    popups.leave(0);
    EXPECT_EQ(popups.open(), Buildings({2, 1}));
    popups.leave(2);
    popups.meet(2);
    EXPECT_EQ(popups.open(), Buildings({1, 2})) << "reopened is younger";
}

/// The objects that are met, each with its building, in the order in which they were.
class NaivePopups {
public:
    void meet(std::size_t building) { met_.push_back(building); }
    void leave(std::size_t building) {
        // Any but the first: the window's age is that of the building's first meeting.
        const auto last = std::find(met_.rbegin(), met_.rend(), building);
        met_.erase(std::next(last).base());
    }
    bool open(std::size_t building) const { return std::ranges::find(met_, building) != met_.end(); }
    Buildings all_open() const {
        Buildings open;
        for (const std::size_t building : met_) {
            if (std::ranges::find(open, building) == open.end()) {
                open.push_back(building);
            }
        }
        return open;
    }
    const Buildings& met() const { return met_; }

private:
    Buildings met_;
};

TEST(Popups, AgreeWithANaiveModelOnRandomSequences) {
    constexpr int kBuildings = 4;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(200)); ++seed) {
        support::Dice dice(seed);
        PlainPopups popups(kBuildings);
        NaivePopups naive;
        for (int i = 0; i < 200; ++i) {
            if (naive.met().empty() || dice.chance(0.5)) {
                const auto building = static_cast<std::size_t>(dice.below(kBuildings));
                const bool opens = !naive.open(building);
                naive.meet(building);
                ASSERT_EQ(popups.meet(building), opens) << "seed " << seed << ", turn " << i;
            } else {
                const auto which = static_cast<std::size_t>(dice.below(static_cast<int>(naive.met().size())));
                const std::size_t building = naive.met()[which];
                naive.leave(building);
                ASSERT_EQ(popups.leave(building), !naive.open(building)) << "seed " << seed << ", turn " << i;
            }
            ASSERT_EQ(popups.open(), naive.all_open()) << "seed " << seed << ", turn " << i;
        }
    }
}

// ---- once, cooldown, dwell ------------------------------------------------------------------------------

constexpr std::size_t kDoor = 7;
constexpr std::size_t kRoom = 8;

TEST(Popups, AskedForOnceDoNotOpenAgain) {
    Popups popups(1);
    const PopupTiming once{true, 0, 0};
    EXPECT_TRUE(popups.meet(0, kDoor, 10, once));
    EXPECT_TRUE(popups.leave(0, kDoor, 20));
    EXPECT_FALSE(popups.meet(0, kDoor, 30, once));
    EXPECT_FALSE(popups.leave(0, kDoor, 40)) << "what isn't open doesn't close";
    EXPECT_TRUE(popups.meet(0, kRoom, 50)) << "another object may";
    EXPECT_EQ(popups.visits(0), 2);
}

TEST(Popups, CoolDownFromTheirClosing) {
    Popups popups(1);
    const PopupTiming timing{false, 10, 0};
    EXPECT_TRUE(popups.meet(0, kDoor, 100, timing));
    EXPECT_TRUE(popups.leave(0, kDoor, 120));
    EXPECT_FALSE(popups.meet(0, kDoor, 129, timing));
    EXPECT_TRUE(popups.open_due(135).empty()) << "a contact asks once";
    EXPECT_FALSE(popups.leave(0, kDoor, 140));
    EXPECT_TRUE(popups.meet(0, kDoor, 130, timing)) << "ten ticks after it closed";
}

TEST(Popups, OpenWhenTheContactHasLasted) {
    Popups popups(2);
    const PopupTiming timing{false, 0, 5};
    EXPECT_FALSE(popups.meet(1, kDoor, 100, timing));
    EXPECT_TRUE(popups.open_due(104).empty());
    EXPECT_EQ(popups.open_due(105), Buildings({1}));
    EXPECT_EQ(popups.open(), Buildings({1}));
    EXPECT_TRUE(popups.open_due(106).empty()) << "once";
    EXPECT_TRUE(popups.leave(1, kDoor, 107));
}

TEST(Popups, DoNotOpenForWhoLeavesBefore) {
    Popups popups(1);
    const PopupTiming timing{false, 0, 5};
    popups.meet(0, kDoor, 100, timing);
    EXPECT_FALSE(popups.leave(0, kDoor, 104));
    popups.meet(0, kDoor, 104, timing);
    EXPECT_TRUE(popups.open_due(105).empty()) << "the wait begins anew";
    EXPECT_EQ(popups.open_due(109), Buildings({0}));
}

TEST(Popups, OpenOnceForTwoThatDwell) {
    Popups popups(1);
    popups.meet(0, kDoor, 100, {false, 0, 5});
    popups.meet(0, kRoom, 100, {false, 0, 5});
    EXPECT_EQ(popups.open_due(105), Buildings({0}));
    EXPECT_EQ(popups.visits(0), 1);
    EXPECT_FALSE(popups.leave(0, kDoor, 106)) << "the room is still met";
    EXPECT_TRUE(popups.leave(0, kRoom, 107));
}

}  // namespace
}  // namespace campuswalk::engine
