#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "engine/testing/event_log.h"

namespace campuswalk::engine {

// EXPECT_THAT(log.events(), HasSequence({"trigger.enter library/door", "popup.open library"}));
// The functions of event_log.h as matchers. Other frameworks print a Verdict directly, such as doctest in
// CHECK(has_sequence(…)).

MATCHER_P(HasEventsInOrder, patterns, "has these events in this order") {
    const Verdict verdict = has_sequence(arg, patterns);
    *result_listener << verdict.found;
    return verdict.holds;
}

inline auto HasSequence(std::vector<std::string> patterns) {
    return HasEventsInOrder(std::move(patterns));
}

MATCHER_P(HasNever, pattern, "has no " + std::string(pattern)) {
    const Verdict verdict = has_never(arg, pattern);
    *result_listener << verdict.found;
    return verdict.holds;
}

MATCHER_P2(HasCount, pattern, count,
           "has a count of " + std::string(pattern) + " that " +
               ::testing::DescribeMatcher<std::size_t>(count, negation)) {
    const std::size_t found = count_of(arg, pattern);
    *result_listener << found << " of " << pattern;
    return ::testing::Matches(count)(found);
}

}  // namespace campuswalk::engine
