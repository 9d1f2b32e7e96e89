#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"

namespace campuswalk::tools::bench {

/// How a set of results differs from the expected one.
struct Difference {
    std::size_t extra = 0;    ///< results that aren't expected
    std::size_t missing = 0;  ///< expected results that are missing

    bool none() const { return extra == 0 && missing == 0; }
    Difference& operator+=(const Difference& o) {
        extra += o.extra;
        missing += o.missing;
        return *this;
    }

    friend bool operator==(const Difference&, const Difference&) = default;
};

/// `+EXTRA/-MISSING`
inline std::string to_string(const Difference& difference) {
    return "+" + std::to_string(difference.extra) + "/-" + std::to_string(difference.missing);
}

/// A line of the CSV: the cost of one query by one engine.
struct Row {
    std::string case_name;
    std::optional<std::size_t> pairs;  ///< overlapping pairs of triangles, for queries that find them
    std::string engine;
    std::string query;
    double least = 0.0;   ///< microseconds per query or per triangle, or bytes per triangle
    double median = 0.0;  ///< the same unit
    std::optional<collision::QueryStatistics> work;  ///< per query
    std::optional<Difference> difference;            ///< where there is something to compare with
};

/// The results of a case of the benchmark.
struct CaseResult {
    std::vector<Row> rows;
    bool ours_right = true;  ///< false: one of our own engines returned a wrong answer, which was printed
};

}  // namespace campuswalk::tools::bench
