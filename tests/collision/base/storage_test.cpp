#include "collision/base/storage.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::collision {
namespace {

using Numbers = Storage<int>;

/// Memory elsewhere, which a view keeps alive.
struct Elsewhere {
    std::shared_ptr<std::vector<int>> owner = std::make_shared<std::vector<int>>(std::vector{4, 5, 6});
    Numbers view() const { return {std::span<const int>(*owner), owner}; }
};

TEST(Storage, BehavesLikeAVector) {
    Numbers numbers = {1, 2};
    numbers.push_back(3);
    numbers.emplace_back() = 4;
    numbers[0] = 9;
    const std::vector<int> more = {7, 8};
    numbers.insert(numbers.begin() + 1, more.begin(), more.end());
    EXPECT_EQ(numbers, (Numbers{9, 7, 8, 2, 3, 4}));
    numbers.pop_back();
    numbers.resize(3);
    EXPECT_EQ(std::as_const(numbers).back(), 8);
    EXPECT_FALSE(numbers.is_external());
    numbers.clear();
    EXPECT_TRUE(numbers.empty());
    numbers.assign(2, 5);
    EXPECT_EQ(numbers, (Numbers{5, 5}));
}

TEST(Storage, KeepsViewedMemoryAlive) {
    Numbers numbers;
    std::weak_ptr<std::vector<int>> owner;
    {
        const Elsewhere there;
        owner = there.owner;
        numbers = there.view();
        EXPECT_EQ(std::as_const(numbers).data(), there.owner->data());
    }
    const Numbers copy = numbers;
    EXPECT_TRUE(copy.is_external());
    numbers = {};
    EXPECT_EQ(copy, (Numbers{4, 5, 6}));
    EXPECT_FALSE(owner.expired());
}

TEST(Storage, CopiesViewedMemoryBeforeChangingIt) {
    const Elsewhere there;
    Numbers numbers = there.view();
    numbers[1] = 0;
    EXPECT_FALSE(numbers.is_external());
    EXPECT_EQ(numbers, (Numbers{4, 0, 6}));
    Numbers grown = there.view();
    grown.push_back(7);
    EXPECT_EQ(grown, (Numbers{4, 5, 6, 7}));
    Numbers iterated = there.view();
    for (int& number : iterated) {
        ++number;
    }
    EXPECT_EQ(iterated, (Numbers{5, 6, 7}));
    EXPECT_EQ(*there.owner, (std::vector{4, 5, 6}));
}

TEST(Storage, IsEmptyWhenMovedFrom) {
    const Elsewhere there;
    for (Numbers from : {Numbers{1, 2, 3}, there.view()}) {
        const Numbers to = std::move(from);
        EXPECT_EQ(to.size(), 3U);
        EXPECT_TRUE(from.empty());  // NOLINT(bugprone-use-after-move)
    }
    Numbers itself = {1, 2};
    const Numbers& same = itself;
    itself = same;
    EXPECT_EQ(itself.size(), 2U);
}

}  // namespace
}  // namespace campuswalk::collision
