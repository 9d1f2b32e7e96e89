#include "scene/model/weld.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

TEST(WeldTable, NumbersKeysInOrderOfInsertion) {
    WeldTable<1> table(0);
    EXPECT_EQ(table.number_of({7}), 0U);
    EXPECT_EQ(table.number_of({3}), 1U);
    EXPECT_EQ(table.number_of({7}), 0U);
    EXPECT_EQ(table.size(), 2U);
}

TEST(WeldTable, AgreesWithAMapWhileItGrows) {
    std::mt19937 random(1);
    WeldTable<2> table(4);
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> expected;
    for (int i = 0; i < 20000; ++i) {
        const std::array<std::uint32_t, 2> key = {static_cast<std::uint32_t>(random() % 97),
                                                  static_cast<std::uint32_t>(random() % 89)};
        const auto number = expected.emplace(key, static_cast<std::uint32_t>(expected.size())).first->second;
        ASSERT_EQ(table.number_of(key), number);
    }
    EXPECT_EQ(table.size(), expected.size());
}

TEST(BitsOf, AreTheSameForBothZeros) {
    EXPECT_EQ(bits_of(-0.0F), bits_of(0.0F));
    EXPECT_NE(bits_of(1.0F), bits_of(-1.0F));
}

}  // namespace
}  // namespace campuswalk::scene
