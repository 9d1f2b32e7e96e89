#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "engine/testing/event_log.h"

namespace campuswalk::engine {

// EXPECT_THAT(log.events(), HasSequence({"trigger.enter library/door", "popup.open library"}));
// The questions of event_log.h as matchers; other frameworks print a Verdict as it is, as doctest does in
// CHECK(has_sequence(…)).

MATCHER_P(HasEventsInOrder, wanted, "has these events in this order") {
    const Verdict verdict = has_sequence(arg, wanted);
    *result_listener << verdict.found;
    return verdict.holds;
}

inline auto HasSequence(std::vector<std::string> wanted) {
    return HasEventsInOrder(std::move(wanted));
}

MATCHER_P(HasNever, unwanted, "has no " + std::string(unwanted)) {
    const Verdict verdict = has_never(arg, unwanted);
    *result_listener << verdict.found;
    return verdict.holds;
}

MATCHER_P2(HasCount, pattern, wanted, "has " + std::string(pattern) + " so often") {
    const std::size_t found = count_of(arg, pattern);
    *result_listener << found << " of " << pattern;
    return ::testing::Matches(wanted)(found);
}

}  // namespace campuswalk::engine
