#include "tools/campuswalk/logs/golden_log.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/logs/log_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kEventsBefore = 5;

/// The header without what doesn't change a walk: a timeout that isn't reached.
std::string comparable(const std::string& header) {
    Json json = Json::parse(header);
    json.erase("timeout");
    return json.dump();  // the same whichever characters were escaped
}

/// A log without verdicts: without expect.fail lines, and without the result and the number of events in
/// walk.end.
struct ComparableLog {
    std::vector<std::string> lines;
    std::vector<std::size_t> numbers;  ///< of the lines in the file, from 1
};

ComparableLog without_verdicts(std::span<const std::string> lines) {
    ComparableLog log;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        // Most lines needn't be parsed.
        const bool maybe = lines[i].find("expect.fail") != std::string::npos ||
                           lines[i].find("walk.end") != std::string::npos;
        const std::optional<LoggedEvent> event = maybe ? logged_event(lines[i]) : std::nullopt;
        if (event && event->kind == "expect.fail") {
            continue;
        }
        std::string line = lines[i];
        if (i == 0 && is_log_header(line)) {
            line = comparable(line);
        } else if (event && event->kind == "walk.end") {
            Json json = Json::parse(line);
            json.erase("result");
            json.erase("events");
            line = json.dump();
        }
        log.lines.push_back(std::move(line));
        log.numbers.push_back(i + 1);
    }
    return log;
}

/// The lines of the golden log. Those of any other file mustn't get into a message.
std::vector<std::string> read_golden(const fs::path& file) {
    return read_lines(file, [&](int number, const std::string& line) {
        if (number == 1 ? !is_log_header(line) : !logged_event(line)) {
            throw scene::InputError({file.generic_string(), number, 1}, "unreadable",
                                    "this isn't a line of a log; write the golden log again with -u");
        }
    });
}

std::string how_they_differ(const ComparableLog& golden, const ComparableLog& run, std::size_t at) {
    if (at >= run.lines.size()) {
        return "the run ends there, and the golden log goes on with " + as_text_line(golden.lines[at]);
    }
    if (at >= golden.lines.size()) {
        return "the golden log ends there, and the run goes on with " + as_text_line(run.lines[at]);
    }
    return difference(golden.lines[at], run.lines[at]).value_or("");
}

/// The scene of a divergence, as far as the run's log contains it.
engine::FailureScene scene_of(const ComparableLog& run, std::size_t at) {
    engine::FailureScene scene;
    const std::size_t last = std::min(at + 1, run.lines.size());
    for (std::size_t i = 0; i < last; ++i) {
        const std::optional<LoggedEvent> event = logged_event(run.lines[i]);
        if (!event) {
            continue;
        }
        scene.tick = event->tick;
        scene.time = event->time;
        scene.position = event->position.value_or(scene.position);
        if (i < at && i + kEventsBefore >= at) {
            scene.last_events.push_back(as_text_line(run.lines[i]));
        }
    }
    return scene;
}

engine::Failure failure_at(const fs::path& file, const ComparableLog& golden, const ComparableLog& run,
                           std::size_t at) {
    engine::Failure failure;
    failure.code = engine::ExpectLog::kName;
    const std::size_t number = at < golden.numbers.size() ? golden.numbers[at]
                               : golden.numbers.empty()   ? 1
                                                          : golden.numbers.back() + 1;
    failure.message = "the log differs from the golden log (" + file.filename().string() + ", line " +
                      std::to_string(number) + "): " + how_they_differ(golden, run, at) +
                      "; if this is intended, run with --update-snapshots=changed";
    failure.scene = scene_of(run, at);
    return failure;
}

engine::Failure missing(const fs::path& file, const ComparableLog& run) {
    engine::Failure failure;
    failure.code = engine::kGoldenMissing;
    failure.message =
        "there is no golden log '" + file.string() + "'; run with -u where you develop, and commit it";
    failure.scene = scene_of(run, run.lines.size());
    return failure;
}

std::string joined(std::span<const std::string> lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line;
        text += '\n';
    }
    return text;
}

}  // namespace

const std::map<std::string, UpdateSnapshots>& update_modes() {
    static const std::map<std::string, UpdateSnapshots> modes = {{"all", UpdateSnapshots::all},
                                                                 {"changed", UpdateSnapshots::changed},
                                                                 {"missing", UpdateSnapshots::missing},
                                                                 {"none", UpdateSnapshots::none}};
    return modes;
}

fs::path reference_file(const fs::path& walk_file, const std::string& project, const std::string& file) {
    fs::path folder = walk_file;
    folder += "-snapshots";
    return folder / ((project.empty() ? "" : project + "-") + file);
}

fs::path golden_log_file(const fs::path& walk_file, const std::string& project) {
    return reference_file(walk_file, project, "log.jsonl");
}

GoldenCheck check_golden(const fs::path& walk_file, const std::string& project,
                         std::span<const std::string> lines, UpdateSnapshots mode) {
    GoldenCheck check;
    const fs::path file = golden_log_file(walk_file, project);
    const auto update = [&] { return GoldenUpdate{file, joined(lines)}; };
    if (mode == UpdateSnapshots::all) {
        check.update = update();
        return check;
    }
    std::error_code error;
    if (!fs::exists(file, error) && !error) {
        if (mode == UpdateSnapshots::none) {
            check.failure = missing(file, without_verdicts(lines));
        } else {
            check.update = update();
        }
        return check;
    }
    const ComparableLog golden = without_verdicts(read_golden(file));
    const ComparableLog run = without_verdicts(lines);
    const std::optional<std::size_t> at = first_divergence(golden.lines, run.lines);
    if (at && mode == UpdateSnapshots::changed) {
        check.update = update();
    } else if (at) {
        check.failure = failure_at(file, golden, run, *at);
    }
    return check;
}

}  // namespace campuswalk::tools
