#include "engine/report/outcome.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace campuswalk::engine {

namespace {

using Codes = std::multiset<std::string>;

std::string listed(const Codes& codes) {
    std::string list;
    for (const std::string& code : codes) {
        list += (list.empty() ? "" : ", ") + code;
    }
    return list;
}

/// The codes among them that no status can expect.
Codes lacks_among(const Codes& failed) {
    Codes lacks;
    std::ranges::copy_if(failed, std::inserter(lacks, lacks.end()), is_lack);
    return lacks;
}

Codes each_once(const Codes& codes) {
    const std::set<std::string> once(codes.begin(), codes.end());
    return {once.begin(), once.end()};
}

/// How the failures differ from those that the status lists; empty if they don't.
std::string mismatch(const Codes& failed, const Codes& expected, const WalkStatus& status) {
    const Codes lacks = lacks_among(failed);
    if (!failed.empty() && lacks.empty() && (expected.empty() || expected == failed)) {
        return "";
    }
    std::string message = "expected to fail";
    message += expected.empty() ? "" : " with " + listed(expected);
    message += status.reason.empty() ? "" : " because " + status.reason;
    if (!lacks.empty()) {
        return message + ", but can't be evaluated: " + listed(lacks);
    }
    return message + (failed.empty() ? ", but passed" : ", but failed with " + listed(failed));
}

}  // namespace

EvaluatedWalk outcome_of_failures(std::vector<Failure> failures, const WalkStatus& status, bool each_counts) {
    EvaluatedWalk evaluated{Outcome::passed, std::move(failures)};
    if (status.kind != WalkStatus::Kind::xfail) {
        evaluated.outcome = evaluated.failures.empty() ? Outcome::passed : Outcome::failed;
        return evaluated;
    }
    Codes failed;
    for (const Failure& failure : evaluated.failures) {
        failed.insert(failure.code);
    }
    const Codes expected(status.codes.begin(), status.codes.end());
    std::string message = each_counts ? mismatch(failed, expected, status)
                                      : mismatch(each_once(failed), each_once(expected), status);
    if (!message.empty()) {
        evaluated.outcome = Outcome::failed;
        evaluated.failures.push_back({status.mark, std::string(kXfailCode), std::move(message), {}});
    }
    return evaluated;
}

}  // namespace campuswalk::engine
