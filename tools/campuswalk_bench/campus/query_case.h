#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/campus/compare_answers.h"
#include "tools/campuswalk_bench/campus/query_runs.h"
#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// A case of the CSV: one kind of query on one mesh. The first engine is ours and is the reference.
template <typename Input, typename Answer>
struct QueryCase {
    const char* case_name = "";
    const char* query = "";
    std::vector<Input> inputs;
    std::vector<QueryEngine<Input, Answer>> engines;
    // Peers' answers may differ by rounding: whether two answers are the same up to rounding and, where they
    // aren't, whether each of them is right up to rounding.
    std::function<bool(const Input&, const Answer&, const Answer&)> is_same;
    std::function<bool(const Input&, const Answer&)> is_right;
};

/// How a peer's answers differ from ours.
struct Disagreement {
    std::size_t by_rounding = 0;  ///< both right
    std::size_t ours_wrong = 0;
    std::size_t theirs_wrong = 0;
    Difference difference;  ///< of the wrong ones
};

template <typename Input, typename Answer>
Disagreement compare_with_peer(const QueryCase<Input, Answer>& query_case, const std::vector<Answer>& ours,
                               const std::vector<Answer>& theirs) {
    Disagreement found;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (query_case.is_same(query_case.inputs[i], ours[i], theirs[i])) {
            continue;
        }
        const bool ours_right = query_case.is_right(query_case.inputs[i], ours[i]);
        const bool theirs_right = query_case.is_right(query_case.inputs[i], theirs[i]);
        found.by_rounding += ours_right && theirs_right ? 1U : 0U;
        found.ours_wrong += ours_right ? 0U : 1U;
        found.theirs_wrong += theirs_right ? 0U : 1U;
        if (!theirs_right) {
            found.difference += compare_answers(theirs[i], ours[i]);
        }
    }
    return found;
}

inline void print_disagreement(const std::string& peer, const std::string& ours, const Disagreement& found) {
    std::printf("%16s    wrong beyond rounding: %zu by %s, %zu by %s; within rounding: %zu\n", "",
                found.theirs_wrong, peer.c_str(), found.ours_wrong, ours.c_str(), found.by_rounding);
}

/// Prints and returns the row of engine `i`; clears `ours_right` if one of our engines is wrong.
template <typename Input, typename Answer>
Row make_row(const QueryCase<Input, Answer>& query_case, const std::vector<QueryRuns<Answer>>& runs,
             std::size_t i, bool& ours_right) {
    const QueryRuns<Answer>& run = runs[i];
    const auto& engine = query_case.engines[i];
    Row row;
    row.case_name = query_case.case_name;
    row.engine = engine.name;
    row.query = query_case.query;
    row.least = run.per_query.least;
    row.median = run.per_query.median;
    std::printf("%16s%12.3f%12.3f", row.engine.c_str(), row.least, row.median);
    if (!engine.is_ours) {
        const Disagreement found = compare_with_peer(query_case, runs[0].answers, run.answers);
        std::printf("\n");
        print_disagreement(row.engine, query_case.engines[0].name, found);
        row.difference = found.difference;
        ours_right = ours_right && found.ours_wrong == 0;
        return row;
    }
    row.difference.emplace();
    for (std::size_t q = 0; q < run.answers.size(); ++q) {
        *row.difference += compare_answers(run.answers[q], runs[0].answers[q]);
    }
    ours_right = ours_right && row.difference->none();
    const std::uint64_t count = query_case.inputs.size();
    row.work = {(run.work.volume_tests + count / 2) / count, (run.work.primitive_tests + count / 2) / count,
                (run.work.transform_updates + count / 2) / count};
    std::printf("%10llu%10llu  %s\n", static_cast<unsigned long long>(row.work->volume_tests),
                static_cast<unsigned long long>(row.work->primitive_tests),
                row.difference->none() ? "" : to_string(*row.difference).c_str());
    return row;
}

/// Runs the case on every engine, prints one or two lines per engine and adds their rows.
template <typename Input, typename Answer>
void run_case(const QueryCase<Input, Answer>& query_case, int rounds, CaseResult& result) {
    const auto runs = run_queries(query_case.inputs, query_case.engines, rounds);
    std::printf("%s, %s (%zu)\n%16s%12s%12s%10s%10s\n", query_case.case_name, query_case.query,
                query_case.inputs.size(), "", "least", "median", "nv", "np");
    for (std::size_t i = 0; i < runs.size(); ++i) {
        result.rows.push_back(make_row(query_case, runs, i, result.ours_right));
    }
}

}  // namespace campuswalk::tools::bench
