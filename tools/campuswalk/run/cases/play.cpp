#include "tools/campuswalk/run/cases/play.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "engine/observers/json_lines.h"
#include "engine/observers/text_log.h"
#include "engine/report/outcome.h"
#include "engine/simulation/run_walk.h"
#include "tools/campuswalk/base/complaints.h"
#include "tools/campuswalk/run/cases/picture_watch.h"
#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using engine::Outcome;
using engine::WalkResult;

namespace {

/// Lines on their way to the parent, some at a time: a message for each would cost more than the walk.
class LinesSaid {
public:
    LinesSaid(const Say& say, Topic topic) : say_(say), topic_(topic) {}

    void add(std::string_view line) {
        lines_.append(line);
        lines_ += '\n';
        if (lines_.size() >= kEnough) {
            flush();
        }
    }

    /// Whoever watches a slow walk wants to see where it is.
    void flush_if_old(std::chrono::steady_clock::time_point now) {
        if (!lines_.empty() && now - last_ > std::chrono::milliseconds(100)) {
            flush();
            last_ = now;
        }
    }

    void flush() {
        if (!lines_.empty()) {
            say_(topic_, lines_);
            lines_.clear();
        }
    }

private:
    static constexpr std::size_t kEnough = std::size_t{1} << 14U;

    const Say& say_;
    Topic topic_;
    std::string lines_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What is said of a walk while it is played, and which images it takes.
class Listener final : public engine::Observer {
public:
    /// `golden` keeps the log as JSON, to be compared.
    Listener(const Say& say, const PlaySettings& settings, bool golden)
        : say_(say),
          settings_(settings),
          golden_(golden),
          log_(say, Topic::log),
          events_(say, Topic::events),
          text_([this](std::string_view line) { log_.add(line); }),
          json_([this](std::string_view line) { add_event(line); }) {}

    void begin(const engine::Walk& walk) override {
        if (settings_.log) {
            text_.begin(walk);
        }
        if (settings_.events || golden_) {
            json_.begin(walk);
        }
    }

    void frame(const engine::TickRecord& record) override {
        if (settings_.log) {
            text_.frame(record);
        }
        if (settings_.events || golden_) {
            json_.frame(record);
        }
        for (const engine::SnapshotStep* step : record.snapshots) {
            images_.push_back(step);
        }
        const auto now = std::chrono::steady_clock::now();
        if (settings_.place && now - last_place_ > std::chrono::milliseconds(200)) {
            last_place_ = now;
            say_(Topic::place, engine::fixed(record.time, 1));
        }
        log_.flush_if_old(now);
        events_.flush_if_old(now);
    }

    void flush() {
        log_.flush();
        events_.flush();
    }

    const std::vector<const engine::SnapshotStep*>& images() const { return images_; }
    const std::vector<std::string>& kept() const { return cached_; }

private:
    void add_event(std::string_view line) {
        if (settings_.events) {
            events_.add(line);
        }
        if (golden_) {
            cached_.emplace_back(line);
        }
    }

    const Say& say_;
    const PlaySettings& settings_;
    bool golden_;
    std::chrono::steady_clock::time_point last_place_ = std::chrono::steady_clock::now();
    LinesSaid log_;
    LinesSaid events_;
    engine::TextLog text_;
    engine::JsonLines json_;
    std::vector<const engine::SnapshotStep*> images_;
    std::vector<std::string> cached_;
};

/// The expectation that the log is the one that was kept; null without one.
const engine::ExpectLog* golden_log_of(const engine::Walk& walk) {
    for (const engine::Expectation& expectation : walk.expectations) {
        const auto* log = std::get_if<engine::ExpectLog>(&expectation);
        if (log != nullptr && log->golden) {
            return log;
        }
    }
    return nullptr;
}

/// Whether the walk isn't as it should be, whatever its log is like.
bool fails_otherwise(const std::vector<engine::Failure>& failures, const engine::WalkStatus& status) {
    const bool may_be_the_log =
        status.kind == engine::WalkStatus::Kind::xfail &&
        (status.codes.empty() ? failures.empty()
                              : std::ranges::find(status.codes, "log") != status.codes.end());
    return !may_be_the_log && engine::outcome_of_evaluators(failures, status).outcome == Outcome::failed;
}

void add_golden_failure(const Case& played, const PlaySettings& settings, const Listener& listener,
                        std::vector<engine::Failure>& failures) {
    const engine::ExpectLog* expected = golden_log_of(played.walk->walk);
    if (expected == nullptr) {
        return;
    }
    GoldenCheck check = check_golden(played.result.file, played.result.project, listener.kept(),
                                     settings.update, fails_otherwise(failures, played.walk->walk.status));
    if (check.failure) {
        check.failure->mark = expected->mark;
        failures.push_back(std::move(*check.failure));
    }
    if (!check.written.empty()) {
        diagnostic_line("wrote " + check.written.generic_string());
    }
    if (!check.withheld.empty()) {
        diagnostic_line("not written, because the walk fails: " + check.withheld.generic_string());
    }
}

void fill(WalkResult& result, const engine::WalkSummary& summary) {
    result.ticks = summary.ticks;
    result.events = summary.events;
    result.distance = summary.distance;
    result.hash = summary.hash;
}

void play_into(WalkResult& result, const Case& played, const PlaySettings& settings,
               const ImageMakers& makers, Listener& listener) {
    const LoadedWalk& loaded = *played.walk;
    InterruptWatch interrupt;
    std::vector<engine::Observer*> observers = {&listener, &interrupt};
    std::optional<ImageWatch> images;
    if (settings.images) {
        std::ranges::copy(images.emplace(played, settings, makers).observers(),
                          std::back_inserter(observers));
    }
    const Records records(settings.records);
    std::ranges::copy(records.observers(), std::back_inserter(observers));
    engine::WalkSummary summary = engine::run_walk(*loaded.campus, loaded.walk, observers);
    fill(result, summary);
    add_golden_failure(played, settings, listener, summary.failures);
    std::vector<engine::Artifact> compared;
    if (images) {
        compared = images->evaluator(summary.failures);
    }
    engine::EvaluatedWalk evaluated =
        engine::outcome_of_evaluators(std::move(summary.failures), loaded.walk.status);
    result.outcome = evaluated.outcome;
    result.failures = std::move(evaluated.failures);
    std::ranges::move(records.write(settings.output, played.folder), std::back_inserter(result.artifacts));
    if (!settings.images) {
        return;
    }
    for (const engine::SnapshotStep* step : listener.images()) {
        for (const std::string& file : files_of(*step)) {
            const bool image = file.ends_with(".png");
            result.artifacts.push_back({fs::path(file).stem().string(), played.folder + "/" + file,
                                        image ? "image/png" : "application/json"});
        }
    }
    std::ranges::move(compared, std::back_inserter(result.artifacts));
    if (images) {
        std::ranges::move(images->sequence_files(), std::back_inserter(result.artifacts));
    }
    if (result.outcome == Outcome::failed && !result.failures.empty()) {
        std::vector<engine::Artifact> drawn = draw_failures(
            *loaded.campus, loaded.walk, result.failures, settings.output, played.folder, *makers.renderers);
        std::ranges::move(drawn, std::back_inserter(result.artifacts));
    }
}

}  // namespace

WalkResult play(const Case& played, const PlaySettings& settings, const ImageMakers& makers, const Say& say) {
    WalkResult result = played.result;
    if (!settings.images && must_fail_in_images(played.walk->walk)) {
        result.outcome = Outcome::skipped;
        result.status_reason = "it must fail in its pictures, and none are drawn";
        return result;
    }
    Listener listener(say, settings, golden_log_of(played.walk->walk) != nullptr);
    try {
        play_into(result, played, settings, makers, listener);
    } catch (const Interrupted&) {
        result.outcome = Outcome::interrupted;
    } catch (const std::exception& error) {
        result.outcome = Outcome::broken;
        result.diagnostics = {std::string("error: ") + error.what()};
    }
    listener.flush();
    return result;
}

void draw_frames(const Case& played, const PlaySettings& settings, engine::render::RendererStore& renderers,
                 std::size_t part, std::size_t parts, const Say& say) {
    std::string diagnostic;
    try {
        const LoadedWalk& loaded = *played.walk;
        const std::unique_ptr<engine::Observer> frames = make_sequence_helper(
            *loaded.campus, loaded.walk, settings.sequence, part, parts,
            [&say](std::string_view frame) { say(Topic::frame, frame); }, renderers);
        engine::Observer* const observers[] = {frames.get()};
        engine::run_walk(*loaded.campus, loaded.walk, observers);
    } catch (const std::exception& error) {
        diagnostic = error.what();
    }
    say(Topic::result, diagnostic);
}

}  // namespace campuswalk::tools
