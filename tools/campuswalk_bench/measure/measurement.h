#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/hybrid/hybrid_tree_contacts.h"
#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

enum class Query : std::uint8_t { all, first };

/// One engine's answer to one query in one placement, and what it took.
struct Measurement {
    std::size_t placement = 0;
    std::size_t engine = 0;
    Query query = Query::all;
    double us_min = 0.0;
    double us_median = 0.0;
    std::optional<collision::HybridContactStatistics> work;
    Difference difference;  ///< query first: a pair that isn't one, or none where there are some
};

struct EngineName {
    std::string name;
    bool is_ours = false;
};

/// Two meshes, held against each other by every engine.
struct Results {
    std::string case_name;
    std::vector<std::size_t> pairs;  ///< a placement each: what the scene says, else `found`
    std::vector<std::size_t> found;  ///< a placement each: those of the first engine, taken for right
    std::vector<EngineName> engines;
    std::vector<Measurement> measurements;  ///< by placement, engine and query; no `first` of who has none
    int rounds = 0;

    /// Null for an engine that isn't here, or doesn't answer this query.
    const Measurement* find(std::size_t placement, const std::string& engine, Query query) const;

    /// Of all placements; empty like the above.
    std::vector<double> least_times(const std::string& engine, Query query) const;
};

/// A row a measurement, queries `all` and `first`.
std::vector<Row> rows_of(const Results& results);

/// exp of the mean of the logarithms.
double geometric_mean(const std::vector<double>& values);

}  // namespace campuswalk::tools::bench
