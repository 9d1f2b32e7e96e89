#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/hybrid/hybrid_tree_contacts.h"
#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

enum class Query : std::uint8_t { all, first };

/// The time, work and errors of one engine on one query in one placement.
struct Measurement {
    std::size_t placement = 0;
    std::size_t engine = 0;
    Query query = Query::all;
    double us_min = 0.0;
    double us_median = 0.0;
    std::optional<collision::HybridContactStatistics> work;
    Difference difference;  ///< of query first: a wrong pair, or none where there are some
};

struct EngineName {
    std::string name;
    bool is_ours = false;
};

/// The measurements of all engines on one scene of two meshes.
struct Results {
    std::string case_name;
    std::vector<std::size_t> pairs;  ///< by placement: the scene's number, or else `found`
    std::vector<std::size_t> found;  ///< by placement: those of the first engine, the reference
    std::vector<EngineName> engines;
    std::vector<Measurement>
        measurements;  ///< by placement, engine and query; without `first` for engines that lack it
    int rounds = 0;

    /// Null for an engine that isn't here or lacks this query.
    const Measurement* find(std::size_t placement, const std::string& engine, Query query) const;

    /// By placement; empty where find() returns null.
    std::vector<double> least_times(const std::string& engine, Query query) const;
};

/// One row per measurement, with queries `all` and `first`.
std::vector<Row> rows_of(const Results& results);

/// exp of the mean of the logarithms.
double geometric_mean(const std::vector<double>& values);

}  // namespace campuswalk::tools::bench
