#include "tools/campuswalk_bench/measure/summary.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "tools/campuswalk_bench/measure/targets.h"

namespace campuswalk::tools::bench {

namespace {

const char* verdict(const Target& target, double value) {
    if (!reaches(target, value, target.must)) {
        return "MISSED";
    }
    return target.aim > 0.0 && reaches(target, value, target.aim) ? "aim reached" : "reached";
}

void print_line(const Target& target, const std::vector<Row>& rows) {
    const bool is_ratio = target.measure != Measure::figure;
    const std::string who = target.ours + (is_ratio ? std::string(" against ") + target.peer : "") + ":";
    std::printf("  %-28s%-37s", target.what, who.c_str());
    const std::optional<double> value = measured(target, rows);
    if (!value) {
        std::printf("not measured\n");
        return;
    }
    std::printf("%7.2f%s  (must %g", *value, is_ratio ? "x" : " ", target.must);
    if (target.aim > 0.0) {
        std::printf(", aim %g", target.aim);
    }
    std::printf(")  %s\n", verdict(target, *value));
}

}  // namespace

void print_summary(const std::vector<Row>& rows) {
    std::printf("\nCompared with the targets: the peer's least time over ours\n");
    for (const Target& target : targets()) {
        if (std::any_of(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.case_name == target.case_name; })) {
            print_line(target, rows);
        }
    }
}

}  // namespace campuswalk::tools::bench
