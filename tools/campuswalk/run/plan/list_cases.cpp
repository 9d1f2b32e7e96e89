#include "tools/campuswalk/run/plan/list_cases.h"

#include <cstdio>

namespace campuswalk::tools {

using engine::Outcome;
using engine::WalkResult;

namespace {

std::string remark(const WalkResult& result) {
    const std::string reason = result.status_reason.empty() ? "" : ": " + result.status_reason;
    if (result.outcome == Outcome::bad_input) {
        return " (has mistakes)";
    }
    if (result.outcome == Outcome::skipped) {
        return " (skip" + reason + ")";
    }
    return result.expected_to_fail ? " (xfail" + reason + ")" : "";
}

}  // namespace

void list_cases(const Plan& plan) {
    for (const Case& each : plan.cases) {
        std::string line = each.result.id;
        for (const std::string& tag : each.result.tags) {
            line += " @" + tag;
        }
        std::printf("%s%s\n", line.c_str(), remark(each.result).c_str());
    }
}

}  // namespace campuswalk::tools
