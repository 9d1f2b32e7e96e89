#include "tools/campuswalk/run/check_outputs.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tools/campuswalk/base/canonical_paths.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/html/html_reports.h"
#include "tools/campuswalk/run/output/output_folder.h"
#include "tools/campuswalk/run/results/reports.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// What the cases are read from, as far as they could be read.
std::set<fs::path> inputs_of(const Plan& plan, CanonicalPaths& canonical) {
    std::set<fs::path> inputs;
    for (const Case& each : plan.cases) {
        inputs.insert(canonical.of(each.result.file));
        if (each.walk) {
            inputs.insert(canonical.of(each.walk->walk.campus));
            for (const fs::path& file : each.walk->campus->files) {
                inputs.insert(canonical.of(file));
            }
        }
    }
    return inputs;
}

void refuse_inputs(const std::vector<ReportTarget>& targets, const std::set<fs::path>& inputs,
                   CanonicalPaths& canonical) {
    for (const ReportTarget& target : targets) {
        if (target.file && inputs.contains(canonical.of(*target.file))) {
            throw error_about(*target.file, "report-unwritable",
                              "this would replace a file that the walks are read from; name another");
        }
    }
}

/// A snapshot there could have a texture's name, or a golden image's.
void refuse_inputs_below(const fs::path& folder, const std::set<fs::path>& inputs,
                         CanonicalPaths& canonical) {
    const fs::path whole = canonical.of(folder);
    for (const fs::path& part : whole) {
        if (part.native().ends_with(".walk.yaml-snapshots")) {
            throw error_about(folder, "output-unwritable",
                              "this is a folder of golden files; choose another");
        }
    }
    const auto first = inputs.lower_bound(whole);
    if (first != inputs.end() && std::ranges::mismatch(whole, *first).in1 == whole.end()) {
        throw error_about(folder, "output-unwritable",
                          "the walks are read from files in this folder; choose another --output");
    }
}

/// Nobody names it on the command line, so that it may not be a link anywhere.
void check_golden_folder(const fs::path& folder) {
    const std::string message = "golden files can't be saved here";
    std::error_code ignored;
    if (fs::is_symlink(folder, ignored)) {
        throw error_about(folder, "output-unwritable", message + ": it is a symbolic link");
    }
    require_writable_folder(folder, message);
}

void check_folders_of_walks(const RunSettings& settings, const Plan& plan, bool images) {
    const std::string message = std::string(images ? "pictures" : "records") + " can't be saved here";
    std::error_code ignored;
    if (fs::symlink_status(settings.output, ignored).type() == fs::file_type::not_found) {
        require_writable_folder(settings.output, message);  // nothing in it can be in the way
        return;
    }
    std::set<fs::path> recordings;  // many in one folder
    for (const Case& each : plan.cases) {
        if (each.walk) {
            require_writable_folder(settings.output / each.folder, message, settings.output);
            recordings.insert((settings.output / report_record_file(each.folder)).parent_path());
        }
    }
    if (records_for_reports(settings.records)) {
        for (const fs::path& folder : recordings) {
            require_writable_folder(folder, message, settings.output);
        }
    }
}

}  // namespace

void check_outputs(const RunOptions& options, const RunSettings& settings, const Plan& plan, bool images) {
    std::vector<ReportTarget> targets = settings.reports;
    if (options.jsonl) {
        targets.push_back({"jsonl-log", options.jsonl});
    }
    check_targets(targets);
    for (const ReportTarget& target : targets) {
        if (target.name == "html") {
            require_html_reports("--reporter");
        }
    }
    CanonicalPaths canonical;
    const std::set<fs::path> inputs = inputs_of(plan, canonical);
    if (!settings.single) {
        targets.push_back({"saved results", settings.saved});
    }
    refuse_inputs(targets, inputs, canonical);
    for (const Case& each : plan.cases) {
        refuse_inputs_below(settings.output / each.folder, inputs, canonical);
        if (settings.update != UpdateSnapshots::none) {
            check_golden_folder(golden_log_file(each.result.file, each.result.project).parent_path());
        }
    }
    if (images || !settings.records.empty()) {  // a failure is drawn, too
        check_folders_of_walks(settings, plan, images);
    }
    if (records_for_reports(settings.records)) {
        require_writable_folder(settings.output / kBundleFolder, "campuses can't be saved here",
                                settings.output);
    }
    if (!settings.single) {
        require_writable_file(settings.saved, "results can't be saved here", settings.output);
    }
}

}  // namespace campuswalk::tools
