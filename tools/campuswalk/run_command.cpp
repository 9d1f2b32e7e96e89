#include "tools/campuswalk/run_command.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <system_error>

#include "engine/decimals.h"
#include "engine/observers/json_lines.h"
#include "engine/observers/text_log.h"
#include "engine/run_walk.h"
#include "tools/campuswalk/complaints.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/log_output.h"
#include "tools/campuswalk/pictures.h"
#include "tools/campuswalk/walk_loader.h"
#include "tools/campuswalk/writable_path.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

std::atomic<bool> interrupted{false};

struct Interrupted {};

/// Ends a walk between two ticks, so that logs and pictures stay whole.
class InterruptWatch final : public engine::Observer {
public:
    void frame(const engine::FrameRecord&) override {
        if (interrupted) {
            throw Interrupted{};
        }
    }
};

scene::InputError about_file(const fs::path& file, const char* code, const std::string& message) {
    return scene::InputError(scene::SourceMark{file.string(), 0, 0}, code, message);
}

bool takes_pictures(const engine::Walk& walk) {
    return std::ranges::any_of(walk.steps, [](const engine::Step& step) {
        return std::holds_alternative<engine::SnapshotStep>(step);
    });
}

/// The walks that may be run; complaints about the others are printed.
std::vector<LoadedWalk> load_all(const std::vector<fs::path>& files, bool& all_good) {
    WalkLoader loader;
    std::vector<LoadedWalk> walks;
    std::set<std::string> names;
    for (const fs::path& file : files) {
        try {
            LoadedWalk loaded = loader.load_walk(file);
            if (!names.insert(loaded.walk.name).second) {
                throw about_file(file, "duplicate-name",
                                 "another walk of this run is called " + loaded.walk.name +
                                     " too, and their pictures would overwrite each other: rename one");
            }
            walks.push_back(std::move(loaded));
        } catch (const scene::InputError& error) {
            complain(error.diagnostics());
            all_good = false;
        }
    }
    return walks;
}

void check_log_file(const std::optional<fs::path>& file) {
    if (!file) {
        return;
    }
    if (file->extension() == ".yaml") {  // as in `--log a.walk.yaml b.walk.yaml`
        throw about_file(*file, "log-unwritable", "a log would overwrite this YAML file; name another");
    }
    if (const std::string why = why_file_unwritable(*file); !why.empty()) {
        throw about_file(*file, "log-unwritable", "the log can't be written here: " + why);
    }
}

/// What can't be written is seen before the walk, not after its first minute, and before anything is
/// overwritten.
void check_outputs(const RunOptions& options, bool pictures, const std::vector<LoadedWalk>& walks) {
    check_log_file(options.log);
    check_log_file(options.jsonl);
    const auto same_for_all = [](const fs::path& file) {
        std::error_code none;
        return fs::weakly_canonical(fs::absolute(file, none), none);
    };
    if (options.log && options.jsonl && same_for_all(*options.log) == same_for_all(*options.jsonl)) {
        throw about_file(*options.jsonl, "log-unwritable", "--log and --jsonl need a file each");
    }
    for (const LoadedWalk& loaded : walks) {
        const fs::path folder = options.output / loaded.walk.name;
        if (!pictures || !takes_pictures(loaded.walk)) {
            continue;
        }
        if (const std::string why = why_folder_unwritable(folder); !why.empty()) {
            throw about_file(folder, "output-unwritable", "pictures can't be saved here: " + why);
        }
    }
}

bool wants_pictures(Backend backend) {
    if (backend == Backend::osmesa && !can_draw()) {
        throw about_file("--rendering-backend", "bad-value", "this build has no rendering: use none");
    }
    return backend != Backend::none && can_draw();
}

void print_outcome(const engine::Walk& walk, const engine::WalkSummary& summary) {
    for (const engine::Failure& failure : summary.failures) {
        complain({{scene::Severity::error, failure.mark, failure.code, failure.message}});
    }
    const double seconds = static_cast<double>(summary.ticks) / walk.sim.ticks_per_second;
    std::fprintf(stderr, "%s: %s after %s s and %s m\n", walk.name.c_str(), summary.passed ? "pass" : "FAIL",
                 engine::fixed(seconds, 1).c_str(), engine::fixed(summary.distance, 1).c_str());
}

/// Where everything that is said about the walks goes.
struct Outputs {
    LogOutput text;
    LogOutput json;
    bool pictures = false;
    fs::path folder;
};

bool run_one(const LoadedWalk& loaded, Outputs& outputs) {
    engine::TextLog text([&](std::string_view line) { outputs.text.line(line); });
    engine::JsonLines json([&](std::string_view line) { outputs.json.line(line); });
    InterruptWatch interrupt;
    std::vector<engine::Observer*> observers = {&text, &json, &interrupt};
    std::unique_ptr<engine::Observer> pictures;
    if (outputs.pictures) {
        pictures = make_snapshot_taker(*loaded.campus, outputs.folder);
        observers.push_back(pictures.get());
    }
    const engine::WalkSummary summary = engine::run_walk(*loaded.campus, loaded.walk, observers);
    outputs.text.flush();
    outputs.json.flush();
    print_outcome(loaded.walk, summary);
    return summary.passed;
}

}  // namespace

int run_walks(const RunOptions& options) {
    bool all_good = true;
    const bool pictures = wants_pictures(options.backend);
    const std::vector<LoadedWalk> walks = load_all(options.walks, all_good);
    if (walks.empty()) {
        return kBadInput;
    }
    check_outputs(options, pictures, walks);
    const auto wants_some = [](const LoadedWalk& loaded) { return takes_pictures(loaded.walk); };
    if (!pictures && options.backend == Backend::automatic && std::ranges::any_of(walks, wants_some)) {
        std::fprintf(stderr, "this build has no rendering: snapshots are logged but not drawn\n");
    }
    Outputs outputs{LogOutput(!options.quiet, options.log), LogOutput(false, options.jsonl), pictures,
                    options.output};

    std::signal(SIGINT, [](int) { interrupted = true; });
    bool all_passed = true;
    try {
        for (const LoadedWalk& loaded : walks) {
            all_passed = run_one(loaded, outputs) && all_passed;
        }
    } catch (const Interrupted&) {
        outputs.text.flush();
        outputs.json.flush();
        std::fprintf(stderr, "interrupted\n");
        return kInterrupted;
    }
    return !all_good ? kBadInput : all_passed ? kPass : kExpectationFailed;
}

}  // namespace campuswalk::tools
