#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"
#include "tools/campuswalk_bench/measure/row.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

/// An engine that answers queries of one kind, one at a time.
template <typename Input, typename Answer>
struct QueryEngine {
    std::string name;
    bool is_ours = false;
    /// Replaces the answer; our engines add to the counters.
    std::function<void(const Input&, Answer&, collision::QueryStatistics&)> answer;
};

/// What one engine answered, and what it took.
template <typename Answer>
struct QueryRuns {
    std::vector<Answer> answers;      ///< by input
    Spread per_query;                 ///< microseconds
    collision::QueryStatistics work;  ///< of all queries together
};

/// Every engine answers every query (see shuffled_runs.h; a run is all queries one after the other).
template <typename Input, typename Answer>
std::vector<QueryRuns<Answer>> run_queries(const std::vector<Input>& inputs,
                                           const std::vector<QueryEngine<Input, Answer>>& engines,
                                           int rounds) {
    std::vector<QueryRuns<Answer>> runs(engines.size());
    for (QueryRuns<Answer>& of_engine : runs) {
        of_engine.answers.resize(inputs.size());
    }
    const auto spreads = shuffled_runs(engines.size(), rounds, [&](std::size_t i) {
        QueryRuns<Answer>& of_engine = runs[i];
        of_engine.work = {};
        return microseconds_of([&] {
            for (std::size_t q = 0; q < inputs.size(); ++q) {
                engines[i].answer(inputs[q], of_engine.answers[q], of_engine.work);
            }
        });
    });
    const auto count = static_cast<double>(inputs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        runs[i].per_query = {spreads[i].least / count, spreads[i].median / count};
    }
    return runs;
}

}  // namespace campuswalk::tools::bench
