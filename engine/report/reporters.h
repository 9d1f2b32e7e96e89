#pragma once

#include <array>
#include <memory>

#include "engine/report/make_reporter.h"

namespace campuswalk::engine {

// What make_reporter chooses from.

std::unique_ptr<Reporter> make_list_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_dot_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_junit_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_tap_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_json_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_jsonl_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_github_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_markdown_reporter(TextSink sink, const ReportStyle& style);
/// The style's own maker makes it; HTML reports are made by engine/html_report, a layer of its own.
std::unique_ptr<Reporter> make_html_reporter(TextSink sink, const ReportStyle& style);

inline constexpr std::array kReporterKinds = {
    ReporterKind{"list",
                 "one line per walk; for a failure also where, what was near, the last events, its pictures",
                 make_list_reporter},
    ReporterKind{"dot", "one character per walk", make_dot_reporter},
    ReporterKind{"junit", "XML: one suite per walk file, one case per walk; times are simulated seconds",
                 make_junit_reporter},
    ReporterKind{"tap", "TAP version 14", make_tap_reporter},
    ReporterKind{"json", "all results and a summary; config/schema/report.schema.json describes each key",
                 make_json_reporter},
    ReporterKind{"jsonl",
                 "one result per line, as soon as it is known: the input of merge-reports and replay",
                 make_jsonl_reporter},
    ReporterKind{"github", "annotations in GitHub's pull requests", make_github_reporter},
    ReporterKind{"markdown", "a table of the walks, and what failed with its pictures: a summary of a CI job",
                 make_markdown_reporter},
    ReporterKind{"html",
                 "one file to open in a browser: the walks in three dimensions, with time, log and pictures",
                 make_html_reporter}};

}  // namespace campuswalk::engine
