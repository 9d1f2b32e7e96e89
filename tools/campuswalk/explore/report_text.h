#pragma once

#include <string>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/explore/coverage.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// Prints a report for people: what is reached, then the findings, numbered, the most important first.
void print_report(const scene::Campus& campus, const engine::WalkReport& report,
                  const engine::AvatarProfile& avatar, const std::vector<Finding>& findings);

/// How much of that the walks visit, and which buildings and triggers they don't.
void print_coverage(const engine::WalkReport& report, const Coverage& coverage);

/// The first few of the words, with commas between, and how many more there are.
std::string first_of(const std::vector<std::string>& words);

}  // namespace campuswalk::tools::explore
