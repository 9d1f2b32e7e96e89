#include <algorithm>
#include <array>
#include <cinttypes>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/loader/walks_config.h"
#include "engine/observers/text_log.h"
#include "engine/simulation/run_walk.h"
#include "scene/base/diagnostic.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/log_output.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/logs/log_lines.h"
#include "tools/campuswalk/logs/recorded_walks.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/results/result_file.h"
#include "tools/campuswalk/run/results/run_key.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

struct ReplayOptions {
    std::filesystem::path run;                 ///< a log or a report in JSON lines
    std::vector<std::filesystem::path> walks;  ///< the walk files of a log
    /// The walks.config.yaml with the walks' projects; without one, that which a report names or, for a log,
    /// the one in this folder or above.
    std::optional<std::filesystem::path> config;
    std::optional<collision::TreeKind> tree;  ///< instead of the walk's own
    bool verify = false;                      ///< compare hashes; otherwise the event log is printed
};

std::string title_of(const RecordedWalk& walk) {
    return walk.file.generic_string() + (walk.project.empty() ? "" : " " + walk.project);
}

/// Loads walks as they were run: in their project, with their timeout.
class RecordedLoader {
public:
    explicit RecordedLoader(const ReplayOptions& options) : options_(options) {}

    LoadedWalk load(const RecordedWalk& recorded) {
        check_place(recorded, recorded.file);
        config::Run run = loader_.read(recorded.file, overrides_of(recorded));
        run.walk.project = recorded.project;
        run.walk.timeout = recorded.timeout;
        run.walk.sim.tree = options_.tree.value_or(run.walk.sim.tree);
        return loader_.ready(std::move(run));
    }

private:
    /// A report names files as it likes; those of the command line are the user's.
    void check_place(const RecordedWalk& recorded, const fs::path& file) const {
        if (std::ranges::find(options_.walks, file) != options_.walks.end()) {
            return;
        }
        static const config::ReadRoots here = config::read_roots(fs::path(".") / "", search_paths());
        if (const std::string why = here.why_unreadable(file); !why.empty()) {
            throw about(recorded, "outside-project", "'" + file.generic_string() + "' " + why);
        }
    }

    config::Overrides overrides_of(const RecordedWalk& recorded) {
        if (recorded.project.empty()) {
            return {};
        }
        const config::WalksConfig& config = config_of(recorded);
        const auto found = std::ranges::find(config.projects, recorded.project, &config::ProjectConfig::name);
        if (found == config.projects.end()) {
            throw about(recorded, "unknown-name",
                        config.file.generic_string() + " has no project '" + recorded.project +
                            "' any more; name another file with --config");
        }
        return found->overrides;
    }

    const config::WalksConfig& config_of(const RecordedWalk& recorded) {
        const std::optional<fs::path> file = options_.config           ? options_.config
                                             : recorded.config.empty() ? config::find_walks_config(".")
                                                                       : recorded.config;
        if (!file) {
            throw about(recorded, "missing-file",
                        "it was run in the project '" + recorded.project +
                            "', and there is no walks.config.yaml here or above; name it with --config");
        }
        const auto [known, is_new] = configs_.try_emplace(*file);
        if (is_new) {
            if (!options_.config) {
                check_place(recorded, *file);
            }
            known->second = config::load_walks_config(as_seen_from_here(*file), search_paths());
        }
        return known->second;
    }

    scene::InputError about(const RecordedWalk& recorded, scene::DiagnosticCode code,
                            const std::string& message) const {
        return scene::InputError({options_.run.string(), static_cast<int>(recorded.line), 1}, code, message);
    }

    const ReplayOptions& options_;
    WalkLoader loader_;
    std::map<fs::path, config::WalksConfig> configs_;
};

/// Loads all walks before any is played, so that nothing is played when one can't be.
std::vector<LoadedWalk> load_all(const ReplayOptions& options, const std::vector<RecordedWalk>& recorded) {
    RecordedLoader loader(options);
    std::vector<LoadedWalk> loaded;
    loaded.reserve(recorded.size());
    for (const RecordedWalk& walk : recorded) {
        loaded.push_back(walk.hash || !options.verify || walk.skipped ? loader.load(walk) : LoadedWalk());
    }
    return loaded;
}

int print_logs(const std::vector<LoadedWalk>& walks) {
    LogOutput output(true, std::nullopt);
    for (const LoadedWalk& loaded : walks) {
        engine::TextLog log([&](std::string_view line) { output.line(line); });
        const std::array<engine::Observer*, 1> observers = {&log};
        engine::run_walk(*loaded.campus, loaded.walk, observers);
    }
    output.flush();
    return kPass;
}

/// Plays the walk and prints whether its hash is the recorded one.
bool has_same_hash(const RecordedWalk& recorded, const LoadedWalk& loaded) {
    const std::uint64_t hash = engine::run_walk(*loaded.campus, loaded.walk, {}).hash;
    if (hash == *recorded.hash) {
        print_line("same    %s", title_of(recorded).c_str());
        return true;
    }
    print_line("DIFFERS %s: hash %016" PRIx64 ", was %016" PRIx64, title_of(recorded).c_str(), hash,
               *recorded.hash);
    return false;
}

/// Passes only if every walk that the recording announces is there and went the same. Walks that were skipped
/// and still are have nothing to compare.
int verify(const Recording& recording, const std::vector<LoadedWalk>& loaded) {
    std::size_t same = 0;
    std::size_t skipped = 0;
    for (std::size_t i = 0; i < recording.walks.size(); ++i) {
        const RecordedWalk& recorded = recording.walks[i];
        if (recorded.hash) {
            same += has_same_hash(recorded, loaded[i]) ? 1U : 0U;
        } else {
            print_line("no hash %s: %s", title_of(recorded).c_str(), recorded.why_no_hash.c_str());
            const bool still_skipped = loaded[i].walk.status.kind == engine::WalkStatus::Kind::skip;
            skipped += recorded.skipped && still_skipped ? 1U : 0U;
        }
    }
    if (recording.missing > 0) {
        print_line("MISSING the results of %s: the report was cut short or the run ended early",
                   scene::plural(recording.missing, "walk").c_str());
    }
    const std::size_t all = recording.walks.size() + recording.missing;
    print_line("%zu of %zu walks went the same again", same, all);
    return same + skipped == all ? kPass : kDifferent;
}

/// Simulates the walks of a log or a report again. Returns the exit code.
int replay_run(const ReplayOptions& options) {
    std::vector<std::string> lines = read_lines(options.run);
    if (!lines.empty() && !is_log_header(lines.front())) {
        lines = unsigned_lines(options.run, lines, shared_run_key(environment_variable));
    }
    const Recording recording = recorded_walks(options.run, lines, options.walks);
    const bool some =
        std::ranges::any_of(recording.walks, [](const RecordedWalk& walk) { return walk.hash.has_value(); });
    if (recording.walks.empty() || (options.verify && !some)) {
        throw error_about(options.run, "nothing-to-replay", "no walk in it has come to its end");
    }
    const std::vector<LoadedWalk> loaded = load_all(options, recording.walks);
    return options.verify ? verify(recording, loaded) : print_logs(loaded);
}

}  // namespace

void add_replay(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<ReplayOptions>();
    Command command = program.add("replay", "Play the walks of a log or a report again");
    command.option({.names = "RUN",
                    .help = "A log (run --jsonl) or a report (--reporter jsonl) as JSON lines",
                    .value = "FILE",
                    .required = true},
                   options->run);
    command.option(
        {.names = "--walk", .help = "The walk file of a walk in a log; reports name theirs", .value = "FILE"},
        options->walks);
    command.option({.names = "--config",
                    .help = "The walks.config.yaml with the walks' projects; without, the one that a report "
                            "names, for a log the one here or above",
                    .value = "FILE"},
                   options->config);
    command.flag({.names = "--verify", .help = "Compare the hashes instead of printing the log"},
                 options->verify);
    add_tree(command, options->tree);
    add_import_options(command);
    add_root_option(command);
    command.footer(
        "Exit code: 0 all the same, 1 something differs or has no hash, 2 bad usage or input, 3 something "
        "failed.");
    command.choose(chosen, [options] { return replay_run(*options); });
}

}  // namespace campuswalk::tools
