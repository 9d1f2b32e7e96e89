#include "tools/campuswalk_bench/campus/differ.h"

#include <algorithm>
#include <iterator>

namespace campuswalk::tools::bench {

Difference differ(const std::optional<double>& answer, const std::optional<double>& right) {
    return answer == right ? Difference{} : Difference{answer ? 1U : 0U, right ? 1U : 0U};
}

Difference differ(char answer, char right) {
    return answer == right ? Difference{} : Difference{answer != 0 ? 1U : 0U, right != 0 ? 1U : 0U};
}

Difference differ(double answer, double right) {
    return answer == right ? Difference{} : Difference{1, 1};
}

Difference differ(const std::vector<std::uint32_t>& answer, const std::vector<std::uint32_t>& right) {
    std::vector<std::uint32_t> both;
    std::set_intersection(answer.begin(), answer.end(), right.begin(), right.end(), std::back_inserter(both));
    return {answer.size() - both.size(), right.size() - both.size()};
}

}  // namespace campuswalk::tools::bench
