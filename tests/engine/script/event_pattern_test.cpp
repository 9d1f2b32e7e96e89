#include "engine/script/event_pattern.h"

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

TEST(EventPattern, MatchesGlobsInKindAndObject) {
    const Event event{0, 1.0, EventKind::collision_enter, "bench/bench-01", {}};
    for (const char* words : {"collision.enter bench/bench-01", "collision.enter", "collision.* bench/*", "*",
                              "*.enter *-01", "collision.enter bench/bench-0[1-3]"}) {
        EXPECT_TRUE(matches(pattern(words), event)) << words;
    }
    for (const char* words : {"collision.exit bench/bench-01", "collision.enter bench", "collision bench/*",
                              "trigger.*", "collision.enter Bench/*"}) {
        EXPECT_FALSE(matches(pattern(words), event)) << words;
    }
}

}  // namespace
}  // namespace campuswalk::engine
