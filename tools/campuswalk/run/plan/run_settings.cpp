#include "tools/campuswalk/run/plan/run_settings.h"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <thread>

#include "engine/report/make_reporter.h"
#include "scene/base/texts_of.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/find_walks.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using config::ProjectConfig;
using config::WalksConfig;
using scene::InputError;
using scene::SourceMark;

namespace {

constexpr double kKillAfter = 3600.0;  // seconds: no test is worth more

SourceMark option(const char* name) {
    return {name, 0, 0};
}

std::optional<WalksConfig> config_for(const RunOptions& options) {
    const std::optional<fs::path> file = options.config ? options.config : config::find_walks_config(".");
    return file ? std::optional(config::load_walks_config(as_seen_from_here(*file), search_paths()))
                : std::nullopt;
}

/// All projects, or those named, in the order of their names.
std::vector<ProjectConfig> projects_for(const RunOptions& options, const WalksConfig& config) {
    const std::vector<std::string> known = scene::texts_of(config.projects, &ProjectConfig::name);
    for (const std::string& name : options.projects) {
        if (std::ranges::find(known, name) == known.end()) {
            throw InputError(option("--project"), "unknown-name",
                             "walks.config.yaml has no project '" + name + "'" +
                                 scene::did_you_mean(name, known) +
                                 (known.empty() ? "; it has none, or there is no such file" : ""));
        }
    }
    std::vector<ProjectConfig> projects;
    for (const ProjectConfig& project : config.projects) {
        if (options.projects.empty() ||
            std::ranges::find(options.projects, project.name) != options.projects.end()) {
            projects.push_back(project);
        }
    }
    return projects.empty() ? std::vector<ProjectConfig>(1) : projects;
}

/// A file or folder that walks.config.yaml says to write: in its folder or below. Only the command line may
/// name others.
fs::path inside_project(const WalksConfig& config, const config::MarkedPath& written) {
    const fs::path folder = config.file.parent_path().lexically_normal();
    const fs::path path = written.path.lexically_normal();
    const fs::path relative = path.lexically_relative(folder.empty() ? fs::path(".") : folder);
    const bool in_repository = std::ranges::find(relative, fs::path(".git")) != relative.end();
    if (path.is_absolute() != folder.is_absolute() || relative.empty() || *relative.begin() == ".." ||
        in_repository) {
        throw InputError(written.mark, "outside-project",
                         "'" + path.generic_string() + "' is " +
                             (in_repository ? "Git's own" : "not below the folder of this file") +
                             "; write there with an option on the command line");
    }
    return as_seen_from_here(path);
}

std::vector<ReportTarget> reports_for(const RunOptions& options, const WalksConfig& config, bool single) {
    std::vector<ReportTarget> reports;
    for (const std::string& text : options.reporters) {
        const std::size_t equals = text.find('=');
        ReportTarget target{text.substr(0, equals), std::nullopt};
        check_reporter(target.name, option("--reporter"));
        if (equals != std::string::npos) {
            target.file = as_seen_from_here(text.substr(equals + 1));
        }
        reports.push_back(std::move(target));
    }
    if (options.reporters.empty()) {
        for (const config::ConfiguredReporter& reporter : config.reporters) {
            check_reporter(reporter.name, reporter.mark);
            ReportTarget& target = reports.emplace_back(ReportTarget{reporter.name, std::nullopt});
            if (reporter.file) {
                target.file = inside_project(config, {reporter.mark, *reporter.file});
                target.configured = reporter.mark;
            }
        }
    }
    const auto printed = [](const ReportTarget& target) { return !target.file; };
    const bool one_to_watch = single && options.reporters.empty() && std::ranges::none_of(reports, printed);
    if (!options.quiet && (reports.empty() || one_to_watch)) {
        reports.push_back({single ? "log" : "list", std::nullopt});
    }
    if (options.log) {
        reports.push_back({"log", options.log});
    }
    for (const ReportTarget& target : reports) {
        if (target.name == "html" && !target.file) {
            throw InputError(option("--reporter"), "bad-value",
                             "an html report needs a file, as in html=report.html");
        }
    }
    if (std::ranges::count_if(reports, printed) > 1) {
        throw InputError(option("--reporter"), "bad-value",
                         "only one report can go to standard output; give the others a file, as in "
                         "junit=junit.xml");
    }
    std::stable_partition(reports.begin(), reports.end(), printed);
    return reports;
}

std::optional<Shard> shard_for(const RunOptions& options, const Environment& environment) {
    if (!options.shard) {
        return shard_from(environment);
    }
    if (std::optional<Shard> shard = parse_shard(*options.shard)) {
        return shard;
    }
    throw InputError(option("--shard"), "bad-shard",
                     "'" + *options.shard + "' must be i/n with i from 1 to n, as in 2/4");
}

/// An html report shows walks from their recordings.
std::vector<std::string> records_for(const RunOptions& options, const std::vector<ReportTarget>& reports) {
    constexpr const char* kOfReports = "report";
    std::vector<std::string> records = options.records;
    if (std::ranges::find(reports, "html", &ReportTarget::name) != reports.end() &&
        std::ranges::find(records, kOfReports) == records.end()) {
        records.emplace_back(kOfReports);
    }
    return records;
}

bool uses_color(ColorChoice choice, const Environment& environment) {
    if (choice != ColorChoice::automatic) {
        return choice == ColorChoice::always;
    }
    return isatty(STDOUT_FILENO) == 1 && !environment("NO_COLOR") && environment("TERM") != "dumb";
}

/// References are written and checked by a person, never by a CI machine.
UpdateSnapshots updates_for(const RunOptions& options, const Environment& environment) {
    const UpdateSnapshots update = options.update.value_or(UpdateSnapshots::none);
    if (update != UpdateSnapshots::none && is_ci(environment)) {
        throw InputError(option("--update-snapshots"), "bad-value",
                         "golden logs and images aren't written where CI is set; unset it if this isn't CI");
    }
    return update;
}

std::vector<fs::path> paths_for(const RunOptions& options, const WalksConfig& config) {
    std::vector<fs::path> paths = options.paths;
    if (paths.empty()) {
        const config::ReadRoots roots = config::read_roots(config.file, search_paths());
        for (const config::MarkedPath& walks : config.walks) {
            const std::string why = options.config ? "" : roots.why_unreadable(walks.path);
            if (!why.empty()) {
                throw InputError(walks.mark, "outside-project",
                                 "'" + walks.path.lexically_normal().generic_string() + "' " + why);
            }
            if (options.update.value_or(UpdateSnapshots::none) != UpdateSnapshots::none) {
                inside_project(config, walks);  // golden files are written beside them
            }
        }
        std::ranges::transform(config.walks, std::back_inserter(paths), &config::MarkedPath::path);
    }
    std::ranges::transform(paths, paths.begin(), as_seen_from_here);
    return paths.empty() ? std::vector<fs::path>{"."} : paths;
}

}  // namespace

void check_reporter(const std::string& name, const SourceMark& mark) {
    std::vector<std::string> known = engine::reporter_names();
    known.emplace_back("log");
    if (std::ranges::find(known, name) == known.end()) {
        throw InputError(mark, "unknown-name",
                         "a reporter must be one of " + joined(known, ", ") + ", not '" + name + "'" +
                             scene::did_you_mean(name, known));
    }
}

RunSettings resolve_settings(const RunOptions& options, const Environment& environment) {
    const WalksConfig config = config_for(options).value_or(WalksConfig());
    RunSettings settings;
    std::error_code ignored;
    settings.paths = paths_for(options, config);
    settings.config = config.file;
    settings.projects = projects_for(options, config);
    settings.single = options.paths.size() == 1 && !fs::is_directory(options.paths.front(), ignored) &&
                      settings.projects.size() == 1 && options.repeat_each == 1;
    settings.shard = shard_for(options, environment);
    if (options.shard_times) {
        settings.shard_times = as_seen_from_here(*options.shard_times);
    }
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    settings.workers = options.workers.value_or(config.workers.value_or(cores));
    settings.max_failures = options.stop_at_first  ? std::optional(1)
                            : options.max_failures ? options.max_failures
                                                   : config.max_failures;
    settings.timeout = options.timeout ? options.timeout : config.timeout;
    settings.kill_after = options.kill_after ? options.kill_after : config.kill_after.value_or(kKillAfter);
    settings.ci = is_ci(environment);
    settings.strict = options.strict || config.strict;
    settings.min_cases = options.min_cases.value_or(config.min_cases.value_or(0));
    settings.forbid_only = options.forbid_only || config.forbid_only || settings.strict || settings.ci;
    settings.tolerance = engine::changed({}, config.snapshots);
    settings.output = options.output  ? as_seen_from_here(*options.output)
                      : config.output ? inside_project(config, *config.output)
                                      : fs::path("out");
    settings.saved = options.save ? as_seen_from_here(*options.save) : settings.output / "last-run.jsonl";
    settings.reports = reports_for(options, config, settings.single);
    settings.records = records_for(options, settings.reports);
    settings.update = updates_for(options, environment);
    settings.color = uses_color(options.color, environment);
    return settings;
}

RunSettings resolve_report_settings(const RunOptions& options, const Environment& environment) {
    RunSettings settings;
    settings.ci = is_ci(environment);
    settings.reports = reports_for(options, WalksConfig(), false);
    settings.color = uses_color(options.color, environment);
    return settings;
}

}  // namespace campuswalk::tools
