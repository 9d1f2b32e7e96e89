#pragma once

#include <string>
#include <string_view>

#include "engine/report/make_reporter.h"
#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// A result in which no field has its default value.
WalkResult full_result();

/// `walks/NAME.walk.yaml`, passed after 4 simulated seconds and 5 metres.
WalkResult passed_result(const std::string& name);
WalkResult failed_result(const std::string& name);
WalkResult skipped_result(const std::string& name);
/// A walk that failed as expected.
WalkResult xfail_result(const std::string& name);
WalkResult bad_input_result(const std::string& name);

/// One of every outcome, an xfail that passed, and a project.
RunReport mixed_report();

/// With texts that could break any format: markup, quotes, line ends, escape sequences, bytes that aren't
/// UTF-8.
RunReport hostile_report();

/// Of a run with these results, in one shard.
RunPlan plan_of(const RunReport& report);

/// The names of the reporters that need nothing but results: all but html.
std::vector<std::string> reporters_of_results();

/// What a reporter writes about a run.
std::string written(std::string_view reporter, const RunReport& report, const ReportStyle& style = {});

}  // namespace campuswalk::engine
