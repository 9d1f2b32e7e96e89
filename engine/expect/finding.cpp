#include "engine/expect/finding.h"

#include <cmath>

#include "engine/events/decimals.h"

namespace campuswalk::engine {

namespace {

constexpr double kHalfOfLastDigit = 0.0005;  // of what is told

}  // namespace

std::string told(const Event& event, double time) {
    return std::string(name_of(event.kind)) + " " + event.object + " " + at_time(time);
}

std::string at_time(double time) {
    return "at " + fixed(time, 3) + " s";
}

std::string told_times(int count) {
    return count == 1 ? "once" : std::to_string(count) + " times";
}

bool still_open(const Limits<int>& limits, int count) {
    const bool too_many =
        (limits.equals && count > *limits.equals) || (limits.at_most && count > *limits.at_most);
    const bool bounded = limits.equals || limits.at_most;
    return !too_many && (bounded || !broken_limit(limits, count).empty());
}

bool still_open(const Limits<double>& limits, double value) {
    const bool too_much = (limits.equals && value > *limits.equals + kHalfOfLastDigit) ||
                          (limits.at_most && value > *limits.at_most);
    const bool bounded = limits.equals || limits.at_most;
    return !too_much && (bounded || !broken_limit(limits, value, "").empty());
}

std::string broken_limit(const Limits<int>& limits, int count) {
    if (limits.equals && count != *limits.equals) {
        return "exactly " + std::to_string(*limits.equals);
    }
    if (limits.at_least && count < *limits.at_least) {
        return "at least " + std::to_string(*limits.at_least);
    }
    if (limits.at_most && count > *limits.at_most) {
        return "at most " + std::to_string(*limits.at_most);
    }
    return "";
}

std::string broken_limit(const Limits<double>& limits, double value, const std::string& unit) {
    if (limits.equals && std::abs(value - *limits.equals) > kHalfOfLastDigit) {
        return "exactly " + fixed(*limits.equals, 3) + unit;
    }
    if (limits.at_least && value < *limits.at_least) {
        return "at least " + fixed(*limits.at_least, 3) + unit;
    }
    if (limits.at_most && value > *limits.at_most) {
        return "at most " + fixed(*limits.at_most, 3) + unit;
    }
    return "";
}

}  // namespace campuswalk::engine
