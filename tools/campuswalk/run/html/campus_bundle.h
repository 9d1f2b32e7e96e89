#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/html_report/html_reporter.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/run/html/html_reports.h"

namespace campuswalk::tools {

/// What a report shows of a campus. `file` as walks name it.
engine::ReportCampus report_campus(const scene::Campus& campus, const std::string& file,
                                   ReportGeometry geometry);

// The same as files, beside a run's results: a report can be made where the campus isn't. The GLB, which is
// packed by gzip, is one that any viewer opens.

/// Without its ending: `campuses/NAME-HASH`, the hash that of the file's path, as campuses in two folders may
/// have one name.
std::string bundle_name(const std::string& file);

/// Throws std::runtime_error.
void write_bundle(const std::filesystem::path& output, const std::string& file,
                  const engine::ReportCampus& campus);

/// None if there is none, or it isn't one.
std::optional<engine::ReportCampus> read_bundle(const std::filesystem::path& output, const std::string& file);

}  // namespace campuswalk::tools
