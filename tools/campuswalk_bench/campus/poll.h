#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/campus/differ.h"
#include "tools/campuswalk_bench/campus/survey.h"
#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// A case of the CSV: one kind of question about one mesh. The first respondent is ours, and taken for right.
template <typename Question, typename Answer>
struct Poll {
    const char* case_name = "";
    const char* query = "";
    std::vector<Question> questions;
    std::vector<Respondent<Question, Answer>> respondents;
    // Peers' answers may differ by rounding: whether two answers are the same but for that, and for those
    // that aren't, whether each is right but for that.
    std::function<bool(const Question&, const Answer&, const Answer&)> is_same;
    std::function<bool(const Question&, const Answer&)> is_right;
};

/// How a peer's answers differ from ours.
struct Disagreement {
    std::size_t by_rounding = 0;  ///< both right
    std::size_t ours_wrong = 0;
    std::size_t theirs_wrong = 0;
    Difference difference;  ///< of those that are wrong
};

template <typename Question, typename Answer>
Disagreement compare(const Poll<Question, Answer>& poll, const std::vector<Answer>& ours,
                     const std::vector<Answer>& theirs) {
    Disagreement found;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (poll.is_same(poll.questions[i], ours[i], theirs[i])) {
            continue;
        }
        const bool ours_right = poll.is_right(poll.questions[i], ours[i]);
        const bool theirs_right = poll.is_right(poll.questions[i], theirs[i]);
        found.by_rounding += ours_right && theirs_right ? 1U : 0U;
        found.ours_wrong += ours_right ? 0U : 1U;
        found.theirs_wrong += theirs_right ? 0U : 1U;
        if (!theirs_right) {
            found.difference += differ(theirs[i], ours[i]);
        }
    }
    return found;
}

inline void print_disagreement(const std::string& peer, const std::string& ours, const Disagreement& found) {
    std::printf("%16s    beyond rounding wrong: %zu by %s, %zu by %s; too close to call: %zu\n", "",
                found.theirs_wrong, peer.c_str(), found.ours_wrong, ours.c_str(), found.by_rounding);
}

/// The row of one respondent; says whether ours were right.
template <typename Question, typename Answer>
Row conclude(const Poll<Question, Answer>& poll, const std::vector<Replies<Answer>>& replies, std::size_t i,
             bool& ours_right) {
    const Replies<Answer>& mine = replies[i];
    const auto& respondent = poll.respondents[i];
    Row row;
    row.case_name = poll.case_name;
    row.engine = respondent.name;
    row.query = poll.query;
    row.least = mine.each.least;
    row.median = mine.each.median;
    std::printf("%16s%12.3f%12.3f", row.engine.c_str(), row.least, row.median);
    if (!respondent.is_ours) {
        const Disagreement found = compare(poll, replies[0].answers, mine.answers);
        std::printf("\n");
        print_disagreement(row.engine, poll.respondents[0].name, found);
        row.difference = found.difference;
        ours_right = ours_right && found.ours_wrong == 0;
        return row;
    }
    row.difference.emplace();
    for (std::size_t q = 0; q < mine.answers.size(); ++q) {
        *row.difference += differ(mine.answers[q], replies[0].answers[q]);
    }
    ours_right = ours_right && row.difference->none();
    const std::uint64_t count = poll.questions.size();
    row.work = {(mine.work.volume_tests + count / 2) / count, (mine.work.primitive_tests + count / 2) / count,
                (mine.work.transform_updates + count / 2) / count};
    std::printf("%10llu%10llu  %s\n", static_cast<unsigned long long>(row.work->volume_tests),
                static_cast<unsigned long long>(row.work->primitive_tests),
                row.difference->none() ? "" : to_string(*row.difference).c_str());
    return row;
}

/// Asks everybody, prints a line or two each, adds their rows.
template <typename Question, typename Answer>
void run(const Poll<Question, Answer>& poll, int rounds, CaseResult& result) {
    const auto replies = survey(poll.questions, poll.respondents, rounds);
    std::printf("%s, %s (%zu)\n%16s%12s%12s%10s%10s\n", poll.case_name, poll.query, poll.questions.size(), "",
                "least", "median", "nv", "np");
    for (std::size_t i = 0; i < replies.size(); ++i) {
        result.rows.push_back(conclude(poll, replies, i, result.ours_right));
    }
}

}  // namespace campuswalk::tools::bench
