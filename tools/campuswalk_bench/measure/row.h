#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"

namespace campuswalk::tools::bench {

/// How a set of answers differs from the right one.
struct Difference {
    std::size_t extra = 0;    ///< answers that are given and aren't right
    std::size_t missing = 0;  ///< answers that are right and aren't given

    bool none() const { return extra == 0 && missing == 0; }
    Difference& operator+=(const Difference& o) {
        extra += o.extra;
        missing += o.missing;
        return *this;
    }

    friend bool operator==(const Difference&, const Difference&) = default;
};

/// `+EXTRA/-MISSING`
std::string to_string(const Difference& difference);

/// A line of the CSV: what one engine's answer to one query took.
struct Row {
    std::string case_name;
    std::optional<std::size_t> pairs;  ///< of overlapping triangles, where that is what is asked for
    std::string engine;
    std::string query;
    double least = 0.0;   ///< microseconds a query, or a triangle built; bytes a triangle
    double median = 0.0;  ///< the same unit
    std::optional<collision::QueryStatistics> work;  ///< a query
    std::optional<Difference> difference;            ///< where there is something to compare with
};

/// What a case of the benchmark found.
struct CaseResult {
    std::vector<Row> rows;
    bool ours_right = true;  ///< false: one of our own engines gave a wrong answer, which was said
};

}  // namespace campuswalk::tools::bench
