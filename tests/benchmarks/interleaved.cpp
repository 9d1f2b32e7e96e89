#include "tests/benchmarks/interleaved.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace campuswalk::bench {

namespace {

double microseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

void print_row(const char* name, const Spread& spread, const char* unit) {
    std::printf("    %-18s %9.2f %9.2f %9.2f  %s\n", name, spread.min, spread.median, spread.max, unit);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values.front(), values[values.size() / 2], values.back()};
}

Outcome measure(const Contest& contest, int rounds) {
    contest.ours();
    contest.peer();
    std::vector<double> ours;
    std::vector<double> peer;
    std::vector<double> ratio;
    const auto count = static_cast<double>(contest.count);
    for (int round = 0; round < rounds; ++round) {
        if (round % 2 == 0) {
            ours.push_back(microseconds(contest.ours) / count);
            peer.push_back(microseconds(contest.peer) / count);
        } else {
            peer.push_back(microseconds(contest.peer) / count);
            ours.push_back(microseconds(contest.ours) / count);
        }
        ratio.push_back(peer.back() / ours.back());
    }
    return {spread_of(ours), spread_of(peer), spread_of(ratio)};
}

void print_heading() {
    std::printf("%-22s %9s %9s %9s\n", "", "min", "median", "max");
}

void print_outcome(const Contest& contest, const Outcome& outcome) {
    std::printf("%s (%zu)\n", contest.questions.c_str(), contest.count);
    print_row("campuswalk", outcome.ours, "us");
    print_row(contest.peer_name.c_str(), outcome.peer, "us");
    print_row("ratio", outcome.ratio, "times campuswalk's time");
}

}  // namespace campuswalk::bench
