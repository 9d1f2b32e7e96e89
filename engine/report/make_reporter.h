#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/reporter.h"

namespace campuswalk::engine {

/// Takes text including its line ends. Throws std::runtime_error if it can't be written.
using TextSink = std::function<void(std::string_view text)>;

/// How a report is written for its reader.
struct ReportStyle {
    bool color = false;  ///< of `list` and `dot`: ANSI colours, for a terminal
    bool quiet = false;  ///< of these two: only problems, and the last line
    /// The run's output folder, where images are, as seen from the repository's root.
    std::string folder = {};
    /// Where the run was started, likewise: see report_paths.h.
    std::string start = {};
    /// Of `markdown`: where the repository's files can be seen; ends with a slash.
    std::string images_url = {};
    /// Makes html reports, which contain more than results: the program knows where that comes from.
    std::function<std::unique_ptr<Reporter>(TextSink sink)> html = {};
};

struct ReporterKind {
    std::string_view name;     ///< as users write it
    std::string_view summary;  ///< one line for `campuswalk help reports`
    std::unique_ptr<Reporter> (*make)(TextSink sink, const ReportStyle& style) = nullptr;
};

std::span<const ReporterKind> reporter_kinds();
std::vector<std::string> reporter_names();

/// Writes to `sink`. Null for an unknown name.
std::unique_ptr<Reporter> make_reporter(std::string_view name, TextSink sink, const ReportStyle& style = {});

}  // namespace campuswalk::engine
