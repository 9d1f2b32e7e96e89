#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/hybrid_tree_contacts.h"

namespace campuswalk::tools::bench {

enum class Query : std::uint8_t { all, first };

/// How a set of pairs differs from the right one.
struct Difference {
    std::size_t extra = 0;    ///< pairs that are reported and don't overlap
    std::size_t missing = 0;  ///< pairs that overlap and aren't reported

    bool none() const { return extra == 0 && missing == 0; }
};

/// `+EXTRA/-MISSING`
std::string to_string(const Difference& difference);

/// One engine's answer to one query in one placement, and what it took.
struct Measurement {
    std::size_t placement = 0;
    std::size_t engine = 0;
    Query query = Query::all;
    double us_min = 0.0;
    double us_median = 0.0;
    std::optional<collision::HybridContactCounters> work;
    Difference difference;  ///< query first: a pair that isn't one, or none where there are some
};

struct EngineName {
    std::string name;
    bool is_ours = false;
};

struct Results {
    std::vector<std::uint32_t> pairs;  ///< a placement each: Table I's
    std::vector<std::size_t> found;    ///< a placement each: those of the first engine, taken for right
    std::vector<EngineName> engines;
    std::vector<Measurement> measurements;  ///< by placement, engine and query; no `first` of who has none
    int rounds = 0;

    /// Null for an engine that isn't here, or doesn't answer this query.
    const Measurement* find(std::size_t placement, const std::string& engine, Query query) const;

    /// Of all placements; empty like the above.
    std::vector<double> least_times(const std::string& engine, Query query) const;
};

/// exp of the mean of the logarithms.
double geometric_mean(const std::vector<double>& values);

}  // namespace campuswalk::tools::bench
