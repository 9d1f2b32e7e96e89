#include "tools/campuswalk/run/html/html_reports.h"

#include <set>
#include <unordered_map>
#include <utility>

#include "config/loader/values/read_roots.h"
#include "engine/html_report/foreign_json.h"
#include "engine/html_report/html_reporter.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/canonical_paths.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/read_below.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/html/campus_bundle.h"
#include "tools/campuswalk/run/html/foreign_images.h"
#include "tools/campuswalk/run/html/viewer_bundle.h"
#include "tools/campuswalk/run/results/result_file.h"
#include "tools/campuswalk/run/results/run_key.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct ResultIndex {
    struct Place {
        std::size_t file = 0;
        std::uintmax_t offset = 0;
    };
    std::vector<ResultFile> files;
    std::unordered_map<std::string, Place> places;  ///< by id
};

/// The results of a jsonl report (or of a folder of shards' reports), to compare another run with. `output`
/// is where the walks' files are. Keeps where each result is, not the results. Throws scene::InputError for a
/// file that isn't one.
engine::ComparedRun open_compared_run(const fs::path& input, const fs::path& output) {
    const auto index = std::make_shared<ResultIndex>();
    index->files = open_result_files({input}, shared_run_key(environment_variable));
    for (std::size_t i = 0; i < index->files.size(); ++i) {
        index->files[i].for_each_located([&](std::uintmax_t offset, const engine::WalkResult& result) {
            index->places.try_emplace(result.id, ResultIndex::Place{i, offset});
        });
    }
    engine::ComparedRun run;
    run.name = title_of_inputs({input});
    run.find = [index](const std::string& id) -> std::optional<engine::WalkResult> {
        const auto found = index->places.find(id);
        return found == index->places.end()
                   ? std::nullopt
                   : std::optional(index->files[found->second.file].read_at(found->second.offset));
    };
    run.for_each = [index](const std::function<void(const engine::WalkResult&)>& visit) {
        for (const ResultFile& file : index->files) {
            file.for_each([&](engine::WalkResult&& result) { visit(result); });
        }
    };
    run.read_artifact = [output](const std::string& path) { return read_below(output, path); };
    return run;
}

/// Reads YAML files of the projects that the user named: results from elsewhere may name any file.
class SourceFiles {
public:
    explicit SourceFiles(const std::vector<fs::path>& named) {
        const std::vector<fs::path> more = search_paths().roots;
        std::set<fs::path> folders;  // files of one folder belong to one project
        std::set<fs::path> projects;
        for (const fs::path& file : named) {
            if (folders.insert(file.parent_path()).second) {
                config::ReadRoots roots(file, more);
                if (projects.insert(roots.project()).second) {
                    roots_.push_back(std::move(roots));
                }
            }
        }
        roots_.emplace_back(fs::path("."), more);
    }

    bool may_read(const fs::path& file) {
        std::error_code ignored;
        if (file.extension() != ".yaml" || !fs::is_regular_file(file, ignored)) {
            return false;
        }
        const fs::path whole = canonical_.of(file);
        return std::ranges::any_of(roots_, [&](const config::ReadRoots& roots) {
            return roots.why_canonical_unreadable(whole).empty();
        });
    }

    std::optional<std::string> read(const std::string& file) {
        try {
            return may_read(file) ? std::optional(read_bytes(file)) : std::nullopt;
        } catch (const scene::InputError&) {
            return std::nullopt;
        }
    }

private:
    std::vector<config::ReadRoots> roots_;
    CanonicalPaths canonical_;
};

/// Finds campuses as walks name them: as they were in the run, else as they are now.
class CampusFinder {
public:
    CampusFinder(const HtmlRequest& request, std::shared_ptr<SourceFiles> sources)
        : output_(request.output),
          geometry_(request.geometry),
          played_(request.campuses),
          sources_(std::move(sources)) {}

    std::optional<engine::ReportCampus> find(const std::string& file) {
        const auto played = played_.find(file);
        std::optional<engine::ReportCampus> campus = played != played_.end()
                                                         ? std::optional(bundled(*played->second, file))
                                                         : read_bundle(output_, file);
        const bool wants_more =
            campus && geometry_ == ReportGeometry::exact && (campus->glb.empty() || campus->error > 0.0);
        if (!campus || wants_more) {
            if (std::optional<engine::ReportCampus> loaded = load(file)) {
                campus = std::move(loaded);
            }
        }
        if (campus && (geometry_ == ReportGeometry::boxes || geometry_ == ReportGeometry::none)) {
            campus->glb.clear();
        }
        if (campus && geometry_ == ReportGeometry::none) {
            drop_objects(*campus);
        }
        return campus;
    }

    /// The campus file that a walk file names.
    std::string campus_file_of(const engine::WalkResult& result) {
        if (!sources_->may_read(result.file)) {
            return "";
        }
        try {
            return loader_.read(result.file).walk.campus.lexically_normal().generic_string();
        } catch (const scene::InputError&) {
            return "";  // the result says what is wrong with it
        }
    }

private:
    engine::ReportCampus bundled(const scene::Campus& campus, const std::string& file) const {
        engine::ReportCampus shown = report_campus(campus, file, geometry_);
        write_bundle(output_, file, shown);
        return shown;
    }

    std::optional<engine::ReportCampus> load(const std::string& file) {
        if (!sources_->may_read(file)) {
            return std::nullopt;
        }
        try {
            return report_campus(*loader_.load_campus(file), file, geometry_);
        } catch (const scene::InputError& error) {
            for (const scene::Diagnostic& diagnostic : error.diagnostics()) {
                print_error_line(scene::to_string(diagnostic));
            }
            return std::nullopt;
        }
    }

    static void drop_objects(engine::ReportCampus& campus) {
        Json entry = Json::parse("{" + campus.entry + "}");
        entry["objects"] = Json::array();
        const std::string text = entry.dump(-1, ' ', false, Json::error_handler_t::replace);
        campus.entry = text.substr(1, text.size() - 2);
    }

    fs::path output_;
    ReportGeometry geometry_;
    CampusesByFile played_;
    std::shared_ptr<SourceFiles> sources_;
    WalkLoader loader_;
};

bool is_finding(const Json& json) {
    return engine::has_numbers(json, {"number"}) && engine::has_strings(json, {"kind", "subject", "text"}) &&
           (!json.contains("at") || engine::has_points(json, {"at"}));  // a building may be nowhere
}

/// All findings of the files, each with the name of its campus.
std::string read_findings(const std::vector<fs::path>& files) {
    if (files.empty()) {
        return "";
    }
    Json all = Json::array();
    for (const fs::path& file : files) {
        const std::optional<Json> json = engine::parse_foreign(read_bytes(file));
        if (!json || !engine::has_numbers(*json, {"campuswalk_explore"}) ||
            (*json)["campuswalk_explore"] != 1 || !engine::has_strings(*json, {"campus"}) ||
            !engine::has_list(*json, "findings", is_finding)) {
            throw scene::InputError({file.generic_string(), 1, 1}, "bad-report",
                                    "this isn't what explore --json writes");
        }
        for (Json finding : (*json)["findings"]) {
            finding["campus"] = (*json)["campus"];
            all.push_back(std::move(finding));
        }
    }
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void require_html_reports(const fs::path& /*subject*/) {}

void write_campus_bundles(const fs::path& output, const CampusesByFile& campuses, ReportGeometry geometry) {
    for (const auto& [file, campus] : campuses) {
        write_bundle(output, file, report_campus(*campus, file, geometry));
    }
}

std::unique_ptr<engine::Reporter> make_html_reporter(const HtmlRequest& request, engine::TextSink sink) {
    const auto sources = std::make_shared<SourceFiles>(request.walks);
    const auto campuses = std::make_shared<CampusFinder>(request, sources);
    engine::HtmlInputs inputs;
    inputs.viewer = viewer_bundle();
    inputs.title = request.title;
    inputs.generator = "campuswalk " CAMPUSWALK_VERSION;
    inputs.command = request.command;
    inputs.read_artifact = [output = request.output](const std::string& path) {
        return read_below(output, path);
    };
    inputs.read_images = image_reader(decode_images);
    inputs.read_source = [sources](const std::string& file) { return sources->read(file); };
    inputs.campus_file_of = [campuses](const engine::WalkResult& result) {
        return campuses->campus_file_of(result);
    };
    inputs.find_campus = [campuses](const std::string& file) { return campuses->find(file); };
    if (request.against) {
        inputs.against = open_compared_run(*request.against, request.against_output.value_or(request.output));
    }
    inputs.findings = read_findings(request.findings);
    inputs.problems = request.problems;
    inputs.start = request.start;
    return std::make_unique<engine::HtmlReporter>(std::move(sink), std::move(inputs));
}

}  // namespace campuswalk::tools
