#include "engine/expect/finding.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/events/decimals.h"

namespace campuswalk::engine {

namespace {

constexpr double kHalfOfLastDigit = 0.0005;  // of what is printed

/// `tolerance` is that of `equals`.
template <typename Number, typename Show>
std::string violated(const Limits<Number>& limits, Number value, Number tolerance, const Show& show) {
    if (limits.equals && std::abs(value - *limits.equals) > tolerance) {
        return "exactly " + show(*limits.equals);
    }
    if (limits.at_least && value < *limits.at_least) {
        return "at least " + show(*limits.at_least);
    }
    if (limits.at_most && value > *limits.at_most) {
        return "at most " + show(*limits.at_most);
    }
    return "";
}

template <typename Number>
bool can_change(const Limits<Number>& limits, Number value, Number tolerance, const std::string& violation) {
    const bool too_much =
        (limits.equals && value > *limits.equals + tolerance) || (limits.at_most && value > *limits.at_most);
    const bool bounded = limits.equals || limits.at_most;
    return !too_much && (bounded || !violation.empty());
}

template <typename Number>
PossibleVerdicts possible(const Limits<Number>& limits, const Interval& numbers, double tolerance) {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    const auto number = [](const std::optional<Number>& limit, double otherwise) {
        return limit ? static_cast<double>(*limit) : otherwise;
    };
    const double least = std::max(number(limits.equals, -kAny), number(limits.at_least, -kAny)) - tolerance;
    const double most = std::min(number(limits.equals, kAny), number(limits.at_most, kAny)) + tolerance;
    return {.holds = least <= most && least <= numbers.most && most >= numbers.least,
            .fails = numbers.least < least || numbers.most > most};
}

}  // namespace

std::optional<std::string> failure_code(const Finding& found, std::string_view name, bool negated) {
    if (!found.lack.empty()) {
        return std::string(found.lack);
    }
    if (found.holds != negated) {
        return std::nullopt;
    }
    return (negated ? "not-" : "") + std::string(name);
}

std::string describe(const Event& event, double time) {
    return std::string(name_of(event.kind)) + " " + event.object + " " + at_time(time);
}

std::string at_time(double time) {
    return "at " + fixed(time, 3) + " s";
}

std::string times_in_words(int count) {
    return count == 1 ? "once" : std::to_string(count) + " times";
}

std::string in_metres(double value) {
    return fixed(value, 3) + " m";
}

std::string violated_limit(const Limits<int>& limits, int count) {
    return violated(limits, count, 0, [](int limit) { return std::to_string(limit); });
}

std::string violated_limit(const Limits<double>& limits, double value, const std::string& unit) {
    return violated(limits, value, kHalfOfLastDigit, [&](double limit) { return fixed(limit, 3) + unit; });
}

bool can_still_change(const Limits<int>& limits, int count) {
    return can_change(limits, count, 0, violated_limit(limits, count));
}

bool can_still_change(const Limits<double>& limits, double value) {
    return can_change(limits, value, kHalfOfLastDigit, violated_limit(limits, value, ""));
}

PossibleVerdicts possible_verdicts(const Limits<int>& limits, const Interval& numbers) {
    return possible(limits, numbers, 0.0);
}

PossibleVerdicts possible_verdicts(const Limits<double>& limits, const Interval& numbers) {
    return possible(limits, numbers, kHalfOfLastDigit);
}

}  // namespace campuswalk::engine
