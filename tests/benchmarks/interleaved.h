#pragma once

#include <functional>
#include <string>
#include <vector>

namespace campuswalk::bench {

struct Spread {
    double min = 0.0;
    double median = 0.0;
    double max = 0.0;
};

/// Of a copy, so that the order of what was measured stays.
Spread spread_of(std::vector<double> values);

/// Two ways to answer the same questions.
struct Contest {
    std::string questions;
    std::size_t count = 0;  ///< questions a round
    std::string peer_name;
    std::function<void()> ours;
    std::function<void()> peer;
};

struct Outcome {
    Spread ours;   ///< microseconds a question
    Spread peer;   ///< microseconds a question
    Spread ratio;  ///< the peer's time over ours, round by round
};

/// One round to warm up, then `rounds` in which both run one after the other, taking turns at going first, so
/// that a machine that slows down slows both.
Outcome measure(const Contest& contest, int rounds);

void print_heading();
void print_outcome(const Contest& contest, const Outcome& outcome);

}  // namespace campuswalk::bench
