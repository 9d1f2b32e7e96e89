#include "scene/base/unicode_words.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

TEST(UnicodeWords, OfAnyScriptAreIds) {
    for (const char* id : {"library", "building_A", "p_1", "main-gate", "v1.2", "图文信息中心", "도서관",
                           "Büro", "мензa", "क्षेत्र", "٣", "a--b"}) {
        EXPECT_TRUE(is_id_word(id)) << id;
    }
}

TEST(UnicodeWords, AreNeitherSignsNorInvisible) {
    for (const char* text : {"", "-a", "a-", ".a", "a.", "_", "a b", "a/b", "a*", "a\u200bb", "a\u202eb", "🏫",
                             "a\tb", "½", "\xff", "a\xc3"}) {
        EXPECT_FALSE(is_id_word(text)) << text;
    }
}

// Of the annex's examples: a letter with a mark, one that is composed otherwise, and Hangul.
TEST(UnicodeWords, AreComposed) {
    EXPECT_EQ(normalized("Bu\u0308ro"), "B\u00fcro");
    EXPECT_EQ(normalized("\u212b"), "\u00c5");
    EXPECT_EQ(normalized("\u1112\u1161\u11ab"), "\ud55c");
    EXPECT_EQ(normalized("plain"), "plain");
    EXPECT_EQ(normalized("\xff"), "\xff");
}

TEST(UnicodeWords, AreMadeOfNames) {
    EXPECT_EQ(to_id_word("Café & Bar"), "café-bar");
    EXPECT_EQ(to_id_word("Main Library (new)"), "main-library-new");
    EXPECT_EQ(to_id_word("Bu\u0308ro 3"), "b\u00fcro-3");
    EXPECT_EQ(to_id_word("图文信息中心"), "图文信息中心");
    EXPECT_EQ(to_id_word("ΘΕΑΤΡΟ"), "θεατρο");
    EXPECT_EQ(to_id_word("— 🏫 —"), "");
    for (const char* name : {"Café & Bar", "a\u0301\u0301-", "도서관 2", "x\u202ey"}) {
        EXPECT_TRUE(is_id_word(to_id_word(name))) << name;
    }
}

}  // namespace
}  // namespace campuswalk::scene
