#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"
#include "tools/campuswalk_bench/measure/row.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

/// Somebody who answers questions of one kind, one at a time.
template <typename Question, typename Answer>
struct Respondent {
    std::string name;
    bool is_ours = false;
    /// Replaces the answer; ours add to the counters.
    std::function<void(const Question&, Answer&, collision::QueryStatistics&)> answer;
};

/// What a respondent said.
template <typename Answer>
struct Replies {
    std::vector<Answer> answers;      ///< a question each
    Spread each;                      ///< microseconds a question
    collision::QueryStatistics work;  ///< of all questions together
};

/// Asks everybody everything (see shuffled_runs.h, where a run is all questions one after the other).
template <typename Question, typename Answer>
std::vector<Replies<Answer>> survey(const std::vector<Question>& questions,
                                    const std::vector<Respondent<Question, Answer>>& respondents,
                                    int rounds) {
    std::vector<Replies<Answer>> replies(respondents.size());
    for (Replies<Answer>& of_one : replies) {
        of_one.answers.resize(questions.size());
    }
    const auto spreads = shuffled_runs(respondents.size(), rounds, [&](std::size_t i) {
        Replies<Answer>& mine = replies[i];
        mine.work = {};
        return microseconds_of([&] {
            for (std::size_t q = 0; q < questions.size(); ++q) {
                respondents[i].answer(questions[q], mine.answers[q], mine.work);
            }
        });
    });
    const auto count = static_cast<double>(questions.size());
    for (std::size_t i = 0; i < replies.size(); ++i) {
        replies[i].each = {spreads[i].least / count, spreads[i].median / count};
    }
    return replies;
}

}  // namespace campuswalk::tools::bench
