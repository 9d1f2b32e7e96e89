#include "tools/campuswalk/run/cases/case_runner.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "engine/expect/failure_scene.h"
#include "engine/expect/state_snapshot.h"
#include "engine/report/outcome.h"
#include "engine/script/player.h"
#include "engine/simulation/run_walk.h"
#include "engine/simulation/simulation.h"
#include "scene/base/atomic_file.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/run/cases/case_stream.h"
#include "tools/campuswalk/run/cases/image_watch.h"
#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

using engine::Outcome;
using engine::WalkResult;

namespace {

/// The expectation that the log equals the golden one; null without one.
const engine::ExpectLog* golden_log_of(const engine::Walk& walk) {
    for (const engine::Expectation& expectation : walk.expectations) {
        const auto* log = std::get_if<engine::ExpectLog>(&expectation);
        if (log != nullptr && log->golden) {
            return log;
        }
    }
    return nullptr;
}

/// Whether a failure says that the walk differs from a golden file, or that there is none to compare with.
bool is_golden_code(std::string_view code) {
    return code == engine::ExpectLog::kName || code == engine::ExpectSnapshot::kName ||
           code == engine::kGoldenMissing || code == engine::kGoldenUnreadable;
}

/// Whether the walk fails whatever its golden files are.
bool fails_regardless_of_goldens(std::vector<engine::Failure> failures, const engine::WalkStatus& status) {
    std::erase_if(failures, [](const engine::Failure& failure) { return is_golden_code(failure.code); });
    const bool goldens_may_decide =
        status.kind == engine::WalkStatus::Kind::xfail &&
        (status.codes.empty() ? failures.empty() : std::ranges::any_of(status.codes, is_golden_code));
    return !goldens_may_decide &&
           engine::outcome_of_failures(std::move(failures), status).outcome == Outcome::failed;
}

/// What a log doesn't tell of a failure, by playing the walk again up to its tick.
void complete_scene(const LoadedWalk& loaded, engine::FailureScene& scene) {
    engine::Simulation simulation(*loaded.campus, loaded.walk, loaded.routes.get());
    engine::StateHistory history;
    do {
        history.on_tick(simulation.step());
    } while (history.now().tick < scene.tick && !simulation.finished());
    std::vector<std::string> events = std::move(scene.last_events);
    scene = engine::scene_of(history.now(), *loaded.campus, loaded.walk.avatar);
    scene.last_events = std::move(events);
}

/// Compares the log with the golden one if the walk expects that.
void check_golden_log(const Case& played, UpdateSnapshots mode, const std::vector<std::string>& log,
                      std::vector<engine::Failure>& failures, std::vector<GoldenUpdate>& updates) {
    const engine::ExpectLog* expected = golden_log_of(played.walk->walk);
    if (expected == nullptr) {
        return;
    }
    GoldenCheck check = check_golden(played.result.file, played.result.project, log, mode);
    if (check.failure) {
        check.failure->mark = expected->mark;
        complete_scene(*played.walk, check.failure->scene);
        failures.push_back(std::move(*check.failure));
    }
    if (check.update) {
        updates.push_back(std::move(*check.update));
    }
}

/// What --strict makes of expectations that nothing has decided: those about images where none are drawn, and
/// what else is expected of a walk that failed at a step as it should.
std::vector<engine::Failure> failures_not_evaluated(const engine::Walk& walk, bool images,
                                                    const std::vector<engine::Undecided>& undecided) {
    std::vector<engine::Failure> failures;
    const auto add = [&](const engine::SourceMark& mark, const std::string& why) {
        failures.push_back(
            {mark, std::string(engine::kNotEvaluated), why + ", and --strict wants all evaluated", {}});
    };
    for (const engine::Expectation& expectation : walk.expectations) {
        if (!images && engine::is_about_images(expectation)) {
            const auto* snapshot = std::get_if<engine::ExpectSnapshot>(&expectation);
            add(snapshot != nullptr ? snapshot->mark : std::get<engine::ExpectVisible>(expectation).mark,
                "nothing draws pictures");
        }
    }
    if (walk.status.kind == engine::WalkStatus::Kind::xfail) {
        for (const engine::Undecided& open : undecided) {
            add(open.mark,
                "the walk failed at a step before this was decided; expect it in a walk of its own");
        }
    }
    return failures;
}

/// Writes and prints the golden files of a walk, unless it fails.
void write_goldens(const std::vector<GoldenUpdate>& updates, bool fails) {
    for (const GoldenUpdate& update : updates) {
        if (!fails) {
            scene::write_file_atomically(update.file, update.bytes);
        }
        print_error_line((fails ? "not written, because the walk fails: " : "wrote ") +
                         update.file.generic_string());
    }
}

bool is_failure_image(std::string_view name) {
    return name.starts_with("failure-") &&
           (name.ends_with("-eyes.png") || name.ends_with("-beside.png") || name.ends_with("-above.png"));
}

/// Those of an earlier run would be mistaken for this one's: the images of its failures, and those of
/// snapshots that the walk may not get to now. Whatever else is in the folder stays.
void remove_images_of_earlier_run(const engine::Walk& walk, const std::filesystem::path& folder) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder, ignored) || !why_folder_unwritable(folder).empty()) {
        return;  // a link may lead anywhere
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        if (is_failure_image(entry.path().filename().string())) {
            std::filesystem::remove(entry.path(), ignored);
        }
    }
    for (const engine::Step& step : walk.steps) {
        if (const auto* snapshot = std::get_if<engine::SnapshotStep>(&step)) {
            for (const std::string& file : files_of(snapshot->name, snapshot->channels)) {
                std::filesystem::remove(folder / file, ignored);
            }
        }
    }
}

/// Plays a case only for its frames and draws one part of them; used as FrameHelpers::Draw.
void draw_frames(const Case& played, const PlaySettings& settings, std::size_t part, std::size_t parts,
                 const Send& send) {
    std::string problem;
    try {
        share_processors(settings.drawing * parts);
        const std::shared_ptr<engine::render::RendererStore> renderers = make_renderers(settings.backend);
        const LoadedWalk& loaded = *played.walk;
        const std::unique_ptr<engine::Observer> frames = make_sequence_helper(
            *loaded.campus, loaded.walk, settings.sequence, part, parts,
            [&send](std::string_view frame) { send(Topic::frame, frame); }, *renderers);
        engine::Observer* const observers[] = {frames.get()};
        engine::run_walk(*loaded.campus, loaded.walk, observers, loaded.routes.get());
    } catch (const std::exception& error) {
        problem = error.what();
    }
    send(Topic::result, problem);
}

void note_broken(WalkResult& result, const std::string& why) {
    result.outcome = Outcome::broken;
    result.diagnostics = {{scene::Severity::error, {}, {}, why}};
}

template <typename Value>
void append(std::vector<Value> from, std::vector<Value>& to) {
    std::ranges::move(from, std::back_inserter(to));
}

}  // namespace

CaseRunner::CaseRunner(const PlaySettings& settings)
    : settings_(settings), renderers_(settings.images ? make_renderers(settings.backend) : nullptr) {}

WalkResult CaseRunner::run(const Case& played, const Send& send) {
    const std::unique_ptr<FrameHelpers> helpers =
        std::exchange(may_fork_, false) ? frame_helpers_for(played) : nullptr;
    WalkResult result = played.result;
    remove_images_of_earlier_run(played.walk->walk, settings_.output / played.folder);
    if (!settings_.images) {
        result.not_evaluated = static_cast<std::uint32_t>(
            std::ranges::count_if(played.walk->walk.expectations, engine::is_about_images));
    }
    if (!settings_.images && !settings_.strict && must_fail_in_images(played.walk->walk)) {
        result.outcome = Outcome::skipped;
        result.status_reason = "it must fail in its pictures, and none are drawn";
        return result;
    }
    CaseStream stream(send, settings_, golden_log_of(played.walk->walk) != nullptr);
    try {
        play_into(result, played, helpers.get(), stream);
    } catch (const Interrupted&) {
        result.outcome = Outcome::interrupted;
    } catch (const scene::InputError& error) {
        result.outcome = Outcome::broken;
        result.diagnostics = error.diagnostics();
    } catch (const std::bad_alloc&) {
        note_broken(result, "it needs more memory than a worker may have; use fewer with -j");
    } catch (const std::exception& error) {
        note_broken(result, error.what());
    }
    stream.flush();
    return result;
}

// Processors that no worker has a walk for are shared evenly among the workers.
std::unique_ptr<FrameHelpers> CaseRunner::frame_helpers_for(const Case& played) const {
    constexpr double kFramesPerPart = 10.0;  // at least, as starting to draw takes as long as some frames
    if (!settings_.images || !settings_.sequence.any()) {
        return nullptr;
    }
    std::size_t parts = std::min(settings_.processes_each, FrameHelpers::kMaxParts);
    if (const auto seconds = engine::planned_seconds(played.walk->walk)) {
        const double frames = *seconds / interval_of(settings_.sequence);
        parts = std::min(parts, static_cast<std::size_t>(std::clamp(frames / kFramesPerPart, 1.0, 1e3)));
    }
    if (parts < 2) {
        return nullptr;
    }
    try {
        auto helpers = std::make_unique<FrameHelpers>(parts, [&, parts](std::size_t part, const Send& send) {
            draw_frames(played, settings_, part, parts, send);
        });
        share_processors(settings_.drawing * parts);
        return helpers;
    } catch (const std::runtime_error&) {
        return nullptr;  // no more processes can be started: this one draws all frames
    }
}

void CaseRunner::play_into(WalkResult& result, const Case& played, FrameHelpers* helpers,
                           CaseStream& stream) const {
    const LoadedWalk& loaded = *played.walk;
    InterruptWatch interrupt;
    std::optional<ImageWatch> images;
    const Records records(settings_.records, *loaded.campus);
    std::vector<engine::Observer*> observers = {&stream, &interrupt};
    if (settings_.images) {
        append(images.emplace(played, settings_, *renderers_, helpers).observers(), observers);
    }
    append(records.observers(), observers);

    engine::WalkSummary summary =
        engine::run_walk(*loaded.campus, loaded.walk, observers, loaded.routes.get());
    result.ticks = summary.ticks;
    result.events = summary.events;
    result.distance = summary.distance;
    result.hash = summary.hash;

    if (settings_.strict) {
        append(failures_not_evaluated(loaded.walk, settings_.images, summary.undecided), summary.failures);
    }
    std::vector<GoldenUpdate> updates;
    check_golden_log(played, settings_.update, stream.saved_lines(), summary.failures, updates);
    std::vector<engine::Artifact> compared;
    if (images) {
        EvaluatedImages evaluated = images->evaluate();
        append(std::move(evaluated.failures), summary.failures);
        append(std::move(evaluated.updates), updates);
        compared = std::move(evaluated.artifacts);
    }
    write_goldens(updates, fails_regardless_of_goldens(summary.failures, loaded.walk.status));
    engine::EvaluatedWalk evaluated =
        engine::outcome_of_failures(std::move(summary.failures), loaded.walk.status, settings_.strict);
    result.outcome = evaluated.outcome;
    result.failures = std::move(evaluated.failures);

    append(records.write(settings_.output, played.folder), result.artifacts);
    if (!images) {
        return;
    }
    append(images->snapshot_files(), result.artifacts);
    append(std::move(compared), result.artifacts);
    append(images->sequence_files(), result.artifacts);
    if (result.outcome == Outcome::failed && !result.failures.empty()) {
        append(draw_failures(*loaded.campus, loaded.walk, result.failures, settings_.output, played.folder,
                             *renderers_, loaded.routes.get()),
               result.artifacts);
    }
}

}  // namespace campuswalk::tools
