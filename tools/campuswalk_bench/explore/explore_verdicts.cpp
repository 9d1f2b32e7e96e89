#include "tools/campuswalk_bench/explore/explore_verdicts.h"

#include <algorithm>
#include <optional>

#include "tools/campuswalk_bench/measure/measurement.h"

namespace campuswalk::tools::bench {

namespace {

/// Of the one's time over the other's, less `included`, where what takes the one's time takes the other's as
/// well; none unless all campuses have both.
std::optional<double> mean_ratio(const std::vector<ExploreScore>& scores, const char* one, const char* other,
                                 std::size_t threads, double included = 0.0) {
    std::vector<double> ratios;
    for (const ExploreScore& score : scores) {
        const ExploreTime* time = score.time(one, threads);
        const ExploreTime* base = score.time(other, threads);
        if (time == nullptr || base == nullptr) {
            return std::nullopt;
        }
        ratios.push_back(std::max(0.01, time->median / base->median - included));
    }
    return ratios.empty() ? std::nullopt : std::optional(geometric_mean(ratios));
}

std::optional<double> most_bytes(const std::vector<ExploreScore>& scores) {
    std::optional<double> most;
    for (const ExploreScore& score : scores) {
        if (score.bytes_per_area) {
            most = std::max(most.value_or(0.0), *score.bytes_per_area);
        }
    }
    return most;
}

/// None without walks.
std::optional<double> share_outside(const std::vector<ExploreScore>& scores,
                                    AdversaryResult ExploreScore::*of) {
    std::size_t walks = 0;
    std::size_t outside = 0;
    for (const ExploreScore& score : scores) {
        walks += (score.*of).walks;
        outside += (score.*of).escapes.size();
    }
    return walks == 0 ? std::nullopt
                      : std::optional(1e4 * static_cast<double>(outside) / static_cast<double>(walks));
}

/// Of what `value` says of the campuses where there is something to say.
template <typename Value>
std::optional<double> mean_of_routes(const std::vector<ExploreScore>& scores, const Value& value) {
    std::vector<double> values;
    for (const ExploreScore& score : scores) {
        if (const std::optional<double> one = score.routes ? value(*score.routes) : std::nullopt) {
            values.push_back(*one);
        }
    }
    return values.empty() ? std::nullopt : std::optional(geometric_mean(values));
}

/// Of the times of `which` routes over Detour's, microseconds.
std::optional<double> mean_query_ratio(const std::vector<ExploreScore>& scores, QueryTimes RouteScore::*which,
                                       double QueryTimes::*time) {
    return mean_of_routes(scores, [which, time](const RouteScore& routes) {
        return routes.peer ? std::optional((routes.*which).*time / ((*routes.peer).*time)) : std::nullopt;
    });
}

/// Per cent of the pairs between which walked strides lead; those that aren't walked as planned don't count.
std::optional<double> share_found(const std::vector<ExploreScore>& scores) {
    std::size_t joined = 0;
    std::size_t found = 0;
    std::size_t blocked = 0;
    for (const ExploreScore& score : scores) {
        if (score.routes) {
            joined += score.routes->joined;
            found += score.routes->found;
            blocked += score.routes->blocked;
        }
    }
    return joined == 0 ? std::nullopt
                       : std::optional(100.0 * (static_cast<double>(found) - static_cast<double>(blocked)) /
                                       static_cast<double>(joined));
}

}  // namespace

std::vector<Verdict> explore_verdicts(const std::vector<ExploreScore>& scores) {
    return {
        at_most("time, one thread each", mean_ratio(scores, "ours", "recast", 1), "x Recast's", 6.0, 2.0),
        at_most("time, two threads each", mean_ratio(scores, "ours", "recast", 2), "x Recast's", 6.0, 2.0),
        at_most("time of all else in a report, one thread", mean_ratio(scores, "report", "ours", 1, 1.0),
                "x reach", 3.0, 1.5),
        at_most("time of all else in a report, two threads", mean_ratio(scores, "report", "ours", 2, 1.0),
                "x reach", 3.0, 1.5),
        at_most("most memory at the peak", most_bytes(scores), " bytes/m2", 400.0, 150.0),
        at_most("walks outside, of 10,000", share_outside(scores, &ExploreScore::adversary), "", 0.0),
        at_most("walks outside that steer in falls, of 10,000", share_outside(scores, &ExploreScore::steered),
                "", 1.0, 0.0),
        at_least("routes found and walked as planned", share_found(scores), "%", 100.0, 100.0),
        at_most("length of routes",
                mean_of_routes(scores, [](const RouteScore& routes) { return routes.length_ratio; }),
                "x Detour's", 1.0, 0.97),
        at_most("time of a new route on known ground, median",
                mean_query_ratio(scores, &RouteScore::ours, &QueryTimes::median), "x Detour's", 40.0, 5.0),
        at_most("time of a new route on known ground, p99",
                mean_query_ratio(scores, &RouteScore::ours, &QueryTimes::p99), "x Detour's", 40.0, 5.0),
        at_most("time of the same route again, median",
                mean_query_ratio(scores, &RouteScore::again, &QueryTimes::median), "x Detour's", 40.0, 5.0),
        at_most("time of the same route again, p99",
                mean_query_ratio(scores, &RouteScore::again, &QueryTimes::p99), "x Detour's", 40.0, 5.0)};
}

bool is_correct(const ExploreScore& score) {
    const bool routes_lead_there =
        !score.routes || (score.routes->found == score.routes->joined && score.routes->blocked == 0 &&
                          score.routes->changed == 0);
    return score.is_same_by_threads && score.adversary.escapes.empty() && routes_lead_there;
}

}  // namespace campuswalk::tools::bench
