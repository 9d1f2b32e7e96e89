#include "tools/campuswalk/run_command.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <set>
#include <stdexcept>
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

LogOutput open_log(bool to_terminal, const std::optional<fs::path>& file) {
    try {
        return LogOutput(to_terminal, file);
    } catch (const std::runtime_error& error) {
        throw about_file(file.value_or("log"), "log-unwritable",
                         std::string("can't be written: ") + error.what());
    }
}

/// Pictures that can't be saved are seen before the walk, not after its first minute.
void make_picture_folders(const fs::path& output, const std::vector<LoadedWalk>& walks) {
    for (const LoadedWalk& loaded : walks) {
        const fs::path folder = output / loaded.walk.name;
        std::error_code error;
        if (takes_pictures(loaded.walk) && !fs::create_directories(folder, error) && error) {
            throw about_file(folder, "output-unwritable", "pictures can't be saved here: " + error.message());
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
    if (pictures) {
        make_picture_folders(options.output, walks);
    } else if (options.backend == Backend::automatic) {
        std::fprintf(stderr, "this build has no rendering: snapshots are logged but not drawn\n");
    }
    Outputs outputs{open_log(!options.quiet, options.log), open_log(false, options.jsonl), pictures,
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
