#include "tools/campuswalk/run/cases/case_runner.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/report/outcome.h"
#include "engine/script/player.h"
#include "engine/simulation/run_walk.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/report_diagnostics.h"
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

/// Whether the walk fails whatever the comparison of its log yields.
bool fails_regardless_of_log(const std::vector<engine::Failure>& failures, const engine::WalkStatus& status) {
    const bool log_may_decide =
        status.kind == engine::WalkStatus::Kind::xfail &&
        (status.codes.empty() ? failures.empty()
                              : std::ranges::find(status.codes, "log") != status.codes.end());
    return !log_may_decide && engine::outcome_of_failures(failures, status).outcome == Outcome::failed;
}

/// Compares the log with the golden one if the walk expects that, and prints what was written.
void add_golden_failure(const Case& played, const PlaySettings& settings, const std::vector<std::string>& log,
                        std::vector<engine::Failure>& failures) {
    const engine::ExpectLog* expected = golden_log_of(played.walk->walk);
    if (expected == nullptr) {
        return;
    }
    GoldenCheck check = check_golden(played.result.file, played.result.project, log, settings.update,
                                     fails_regardless_of_log(failures, played.walk->walk.status));
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

/// Plays a case only for its frames and draws one part of them; used as FrameHelpers::Draw.
void draw_frames(const Case& played, const PlaySettings& settings, std::size_t part, std::size_t parts,
                 const Say& say) {
    std::string problem;
    try {
        share_processors(settings.drawing * parts);
        const std::shared_ptr<engine::render::RendererStore> renderers = make_renderers(settings.backend);
        const LoadedWalk& loaded = *played.walk;
        const std::unique_ptr<engine::Observer> frames = make_sequence_helper(
            *loaded.campus, loaded.walk, settings.sequence, part, parts,
            [&say](std::string_view frame) { say(Topic::frame, frame); }, *renderers);
        engine::Observer* const observers[] = {frames.get()};
        engine::run_walk(*loaded.campus, loaded.walk, observers);
    } catch (const std::exception& error) {
        problem = error.what();
    }
    say(Topic::result, problem);
}

template <typename Value>
void append(std::vector<Value> from, std::vector<Value>& to) {
    std::ranges::move(from, std::back_inserter(to));
}

}  // namespace

CaseRunner::CaseRunner(const PlaySettings& settings)
    : settings_(settings), renderers_(settings.images ? make_renderers(settings.backend) : nullptr) {}

WalkResult CaseRunner::run(const Case& played, const Say& say) {
    const std::unique_ptr<FrameHelpers> helpers =
        std::exchange(may_fork_, false) ? frame_helpers_for(played) : nullptr;
    WalkResult result = played.result;
    if (!settings_.images && must_fail_in_images(played.walk->walk)) {
        result.outcome = Outcome::skipped;
        result.status_reason = "it must fail in its pictures, and none are drawn";
        return result;
    }
    CaseStream stream(say, settings_, golden_log_of(played.walk->walk) != nullptr);
    try {
        play_into(result, played, helpers.get(), stream);
    } catch (const Interrupted&) {
        result.outcome = Outcome::interrupted;
    } catch (const scene::InputError& error) {  // its text names the place, the severity and the code
        result.outcome = Outcome::broken;
        result.diagnostics = {error.what()};
    } catch (const std::exception& error) {
        result.outcome = Outcome::broken;
        result.diagnostics = {std::string("error: ") + error.what()};
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
        auto helpers = std::make_unique<FrameHelpers>(parts, [&, parts](std::size_t part, const Say& say) {
            draw_frames(played, settings_, part, parts, say);
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
    const Records records(settings_.records);
    std::vector<engine::Observer*> observers = {&stream, &interrupt};
    if (settings_.images) {
        append(images.emplace(played, settings_, *renderers_, helpers).observers(), observers);
    }
    append(records.observers(), observers);

    engine::WalkSummary summary = engine::run_walk(*loaded.campus, loaded.walk, observers);
    result.ticks = summary.ticks;
    result.events = summary.events;
    result.distance = summary.distance;
    result.hash = summary.hash;

    add_golden_failure(played, settings_, stream.saved_lines(), summary.failures);
    std::vector<engine::Artifact> compared;
    if (images) {
        compared = images->evaluate(summary.failures);
    }
    engine::EvaluatedWalk evaluated =
        engine::outcome_of_failures(std::move(summary.failures), loaded.walk.status);
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
                             *renderers_),
               result.artifacts);
    }
}

}  // namespace campuswalk::tools
