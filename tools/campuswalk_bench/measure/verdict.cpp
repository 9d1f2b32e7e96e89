#include "tools/campuswalk_bench/measure/verdict.h"

#include <cstdio>
#include <utility>

namespace campuswalk::tools::bench {

namespace {

bool reaches(const Verdict& verdict, double bound) {
    return verdict.more_is_better ? *verdict.value >= bound : *verdict.value <= bound;
}

Verdict with_outcome(Verdict verdict) {
    verdict.holds = verdict.value && reaches(verdict, verdict.must);
    return verdict;
}

}  // namespace

Verdict at_most(std::string what, std::optional<double> value, const char* unit, double must,
                std::optional<double> aim) {
    return with_outcome({std::move(what), value, unit, false, must, aim, false});
}

Verdict at_least(std::string what, std::optional<double> value, const char* unit, double must,
                 std::optional<double> aim) {
    return with_outcome({std::move(what), value, unit, true, must, aim, false});
}

void print_value(const Verdict& verdict) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.*f%s", *verdict.value >= 1000.0 ? 0 : 2, *verdict.value,
                  verdict.unit);
    std::printf("%20s  ", text);
}

void print_verdicts(const std::vector<Verdict>& verdicts, int width, void (*print)(const Verdict& verdict)) {
    for (const Verdict& verdict : verdicts) {
        std::printf("  %-*s", width, verdict.what.c_str());
        if (!verdict.value) {
            std::printf("not measured\n");
            continue;
        }
        print(verdict);
        std::printf("(must %g", verdict.must);
        if (verdict.aim) {
            std::printf(", aim %g", *verdict.aim);
        }
        const bool is_aim = verdict.aim && reaches(verdict, *verdict.aim);
        std::printf(")  %s\n", !verdict.holds ? "MISSED" : is_aim ? "aim reached" : "reached");
    }
}

}  // namespace campuswalk::tools::bench
