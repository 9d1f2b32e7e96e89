#include "tools/campuswalk_bench/campus/compare_answers.h"

#include <algorithm>
#include <iterator>

namespace campuswalk::tools::bench {

Difference compare_answers(const std::optional<double>& answer, const std::optional<double>& expected) {
    return answer == expected ? Difference{} : Difference{answer ? 1U : 0U, expected ? 1U : 0U};
}

Difference compare_answers(char answer, char expected) {
    return answer == expected ? Difference{} : Difference{answer != 0 ? 1U : 0U, expected != 0 ? 1U : 0U};
}

Difference compare_answers(double answer, double expected) {
    return answer == expected ? Difference{} : Difference{1, 1};
}

Difference compare_answers(const std::vector<std::uint32_t>& answer,
                           const std::vector<std::uint32_t>& expected) {
    std::vector<std::uint32_t> both;
    std::set_intersection(answer.begin(), answer.end(), expected.begin(), expected.end(),
                          std::back_inserter(both));
    return {answer.size() - both.size(), expected.size() - both.size()};
}

}  // namespace campuswalk::tools::bench
