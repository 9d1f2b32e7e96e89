#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/explore/adversary.h"
#include "tools/campuswalk_bench/explore/disagreement.h"
#include "tools/campuswalk_bench/explore/explored_campus.h"
#include "tools/campuswalk_bench/explore/route_case.h"

namespace campuswalk::tools::bench {

/// What is measured.
struct ExploreCaseSettings {
    int rounds = 5;
    std::size_t walks = 0;          ///< of the adversary
    std::size_t steered_walks = 0;  ///< likewise, steering in falls; only where that is asked for
    std::size_t routes = 0;         ///< between random pairs of places
};

/// How long one of them took on so many threads, seconds.
struct ExploreTime {
    std::string engine;  ///< "ours", "recast", or "report": ours with reasons, traps, holes and so on
    std::size_t threads = 1;
    double least = 0.0;
    double median = 0.0;
    double processor = 0.0;  ///< of all threads together, the median: on a busy machine the fairer figure
};

/// Our exploration of a campus, beside Recast's navigation mesh of the same triangles.
struct ExploreScore {
    std::string campus;
    std::size_t triangles = 0;
    double area = 0.0;  ///< reached, square metres
    std::size_t nodes = 0;
    std::uint64_t ticks = 0;
    std::optional<double> bytes_per_area;  ///< at the peak, per square metre; none where heaps aren't counted
    std::vector<ExploreTime> times;        ///< without Recast's where that isn't built
    bool is_same_by_threads = true;
    std::optional<Disagreement> disagreement;
    AdversaryResult adversary;
    AdversaryResult steered;
    std::optional<RouteScore> routes;

    /// Null for an engine that isn't here.
    const ExploreTime* time(const std::string& engine, std::size_t threads) const;
};

/// Prints what it measures. Reach alone: the campus is in memory, with its trees.
ExploreScore explore_campus(const ExploredCampus& campus, const ExploreCaseSettings& settings);

}  // namespace campuswalk::tools::bench
