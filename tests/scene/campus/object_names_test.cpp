#include "scene/campus/object_names.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

using Words = std::vector<std::string>;

TEST(ObjectWord, IsKebabCase) {
    EXPECT_EQ(object_word("tree_01"), "tree-01");
    EXPECT_EQ(object_word("Tree_01.Leaf"), "tree-01-leaf");
    EXPECT_EQ(object_word("  Main  Library! "), "main-library");
    EXPECT_EQ(object_word("a/b\nc"), "a-b-c");
    EXPECT_EQ(object_word("bench"), "bench");
}

TEST(ObjectWord, KeepsOtherScriptsAndDefaultsToNode) {
    EXPECT_EQ(object_word("도서관_1"), "도서관-1");
    EXPECT_EQ(object_word(""), "node");
    EXPECT_EQ(object_word("***"), "node");
}

TEST(DistinctWords, NumbersRepeatsInOrder) {
    EXPECT_EQ(distinct_words({"tree", "bench", "Tree", "tree"}),
              (Words{"tree", "bench", "tree-2", "tree-3"}));
}

TEST(DistinctWords, KeepsNamesThatLookNumbered) {
    EXPECT_EQ(distinct_words({"tree", "tree", "tree_2"}), (Words{"tree", "tree-3", "tree-2"}));
    EXPECT_EQ(distinct_words({"tree_2", "tree", "tree_2", "tree"}),
              (Words{"tree-2", "tree", "tree-2-2", "tree-3"}));
}

}  // namespace
}  // namespace campuswalk::scene
