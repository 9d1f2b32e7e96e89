#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/make_reporter.h"
#include "engine/report/reporter.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/run/plan/run_options.h"

namespace campuswalk::tools {

/// By the file that walks name.
using CampusesByFile = std::map<std::string, std::shared_ptr<const scene::Campus>>;

// A build without HTML reports (CAMPUSWALK_HTML=OFF) has these functions, too.

/// Throws scene::InputError (not-built) in a build without them; `subject` is what asks for one.
void require_html_reports(const std::filesystem::path& subject);

/// Writes OUTPUT/campuses/NAME-HASH.json and .glb.gz for each campus: a report can be made from them later,
/// elsewhere. Throws std::runtime_error. Does nothing in a build without.
void write_campus_bundles(const std::filesystem::path& output, const CampusesByFile& campuses,
                          ReportGeometry geometry);

/// What `report` was asked for, or `run` with an html reporter.
struct HtmlRequest {
    std::filesystem::path output = "out";  ///< where the walks' files and the campus bundles are
    ReportGeometry geometry = ReportGeometry::simplified;
    CampusesByFile campuses;  ///< of a run that goes on: each is bundled when its first walk is shown
    std::string title;
    std::string command;                           ///< that made the run, if known
    std::vector<std::filesystem::path> walks;      ///< files that the user named: their projects may be read
    std::optional<std::filesystem::path> against;  ///< a jsonl report, or a folder of them
    std::optional<std::filesystem::path> against_output;  ///< the other run's `output`; the same if not given
    std::vector<std::filesystem::path> findings;          ///< of explore --json
    std::vector<std::string> problems;                    ///< why results may be missing
    std::string start;  ///< where the run was started, as seen from the repository's root
};

/// Throws scene::InputError for files that aren't what they should be.
std::unique_ptr<engine::Reporter> make_html_reporter(const HtmlRequest& request, engine::TextSink sink);

}  // namespace campuswalk::tools
