#pragma once

#include <array>
#include <memory>
#include <utility>

#include "engine/report/make_reporter.h"

namespace campuswalk::engine {

// What make_reporter chooses from, each in its own file.

std::unique_ptr<Reporter> make_list_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_dot_reporter(TextSink sink, const ReportStyle& style);
std::unique_ptr<Reporter> make_junit_reporter(TextSink sink);
std::unique_ptr<Reporter> make_tap_reporter(TextSink sink);
std::unique_ptr<Reporter> make_json_reporter(TextSink sink);
std::unique_ptr<Reporter> make_jsonl_reporter(TextSink sink);
std::unique_ptr<Reporter> make_github_reporter(TextSink sink);

template <std::unique_ptr<Reporter> (*make)(TextSink)>
std::unique_ptr<Reporter> without_style(TextSink sink, const ReportStyle&) {
    return make(std::move(sink));
}

inline constexpr std::array kReporterKinds = {
    ReporterKind{"list",
                 "one line per walk; for a failure also where, what was near, the last events, its pictures",
                 make_list_reporter},
    ReporterKind{"dot", "one character per walk", make_dot_reporter},
    ReporterKind{"junit", "XML: one suite per walk file, one case per walk; times are simulated seconds",
                 without_style<make_junit_reporter>},
    ReporterKind{"tap", "TAP version 14", without_style<make_tap_reporter>},  // an xfail is a TODO
    ReporterKind{"json", "all results and a summary; config/schema/report.schema.json describes each key",
                 without_style<make_json_reporter>},
    ReporterKind{"jsonl",
                 "one result per line, as soon as it is known: the input of merge-reports and replay",
                 without_style<make_jsonl_reporter>},
    ReporterKind{"github", "annotations in GitHub's pull requests", without_style<make_github_reporter>}};

}  // namespace campuswalk::engine
