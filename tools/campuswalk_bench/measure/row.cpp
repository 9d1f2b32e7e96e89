#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

std::string to_string(const Difference& difference) {
    return "+" + std::to_string(difference.extra) + "/-" + std::to_string(difference.missing);
}

}  // namespace campuswalk::tools::bench
