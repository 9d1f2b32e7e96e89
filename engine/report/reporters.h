#pragma once

#include <memory>

#include "engine/report/make_reporter.h"

namespace campuswalk::engine {

// What make_reporter chooses from, a file each.

/// A line a case, then what is not as it should be in full, then a line of counts.
std::unique_ptr<Reporter> make_list_reporter(TextSink sink, const ReportStyle& style);
/// A character a case, the rest as `list`.
std::unique_ptr<Reporter> make_dot_reporter(TextSink sink, const ReportStyle& style);
/// JUnit's XML: a file is a suite, a walk in it a case, seconds are simulated ones.
std::unique_ptr<Reporter> make_junit_reporter(TextSink sink);
/// Test Anything Protocol, version 14. An xfail is a TODO.
std::unique_ptr<Reporter> make_tap_reporter(TextSink sink);
/// One object (config/schema/report.schema.json), a result a line inside of it.
std::unique_ptr<Reporter> make_json_reporter(TextSink sink);
/// A header and a line a result, as they come (config/schema/report-line.schema.json).
std::unique_ptr<Reporter> make_jsonl_reporter(TextSink sink);
/// GitHub's workflow commands: an annotation a failure.
std::unique_ptr<Reporter> make_github_reporter(TextSink sink);

}  // namespace campuswalk::engine
