#include "tools/campuswalk/run/plan/strict_rules.h"

#include <string>
#include <variant>

#include "engine/events/decimals.h"
#include "engine/expect/can_fail.h"
#include "engine/simulation/spawn_fall.h"

namespace campuswalk::tools {

using engine::ImageTolerance;
using engine::WalkStatus;

namespace {

/// Whether images may differ that the defaults tell apart.
bool is_looser_than_default(const ImageTolerance& tolerance) {
    const ImageTolerance standard;
    return tolerance.threshold > standard.threshold || tolerance.min_tile_ssim < standard.min_tile_ssim ||
           tolerance.max_diff_pixels.value_or(0) > 0 || tolerance.max_diff_pixel_ratio.value_or(0.0) > 0.0 ||
           !tolerance.masks.empty();
}

scene::Diagnostic refusal(const engine::SourceMark& mark, const std::string& what) {
    return {scene::Severity::error, mark, "strict", what};
}

/// Refuses `fall: true` of a walk that doesn't begin with a fall. The opposite is an error without --strict,
/// too.
void check_fall(const scene::Campus& campus, const engine::Walk& walk, const engine::SpawnStep& spawn,
                std::vector<scene::Diagnostic>& errors) {
    if (!spawn.fall) {
        return;
    }
    const engine::SpawnFall fall = engine::fall_at_spawn(campus, walk);
    if (fall.lands && fall.height <= engine::kSpawnFall) {
        errors.push_back(refusal(spawn.mark, "'fall: true' isn't so: from " + spawn.label + " at " +
                                                 engine::fixed(spawn.position) + " the walk falls by only " +
                                                 engine::fixed(fall.height, 2) + " m; remove it"));
    }
}

}  // namespace

std::vector<scene::Diagnostic> strict_errors(const engine::Walk& walk, const ImageTolerance& tolerance) {
    std::vector<scene::Diagnostic> errors;
    const auto refuse = [&](const engine::SourceMark& mark, const std::string& what) {
        errors.push_back({scene::Severity::error, mark, "strict", what + ", which --strict doesn't allow"});
    };
    if (walk.status.kind == WalkStatus::Kind::skip) {
        refuse(walk.status.mark, "the walk is skipped");
    }
    if (walk.status.kind == WalkStatus::Kind::xfail && walk.status.codes.empty()) {
        refuse(walk.status.mark, "the walk may fail in any way ('xfail' without 'failures')");
    }
    if (!engine::expects_something(walk)) {
        refuse(walk.mark, "the walk expects nothing");
    }
    for (const engine::Expectation& expectation : walk.expectations) {
        const auto* snapshot = std::get_if<engine::ExpectSnapshot>(&expectation);
        if (snapshot != nullptr && is_looser_than_default(engine::changed(tolerance, snapshot->tolerance))) {
            refuse(snapshot->mark, "the snapshot may differ by more than the default tolerance");
        }
    }
    return errors;
}

std::vector<scene::Diagnostic> strict_errors(const scene::Campus& campus, const engine::Walk& walk) {
    std::vector<scene::Diagnostic> errors;
    if (const auto* spawn =
            walk.steps.empty() ? nullptr : std::get_if<engine::SpawnStep>(&walk.steps.front())) {
        check_fall(campus, walk, *spawn, errors);
    }
    for (const engine::VacuousExpectation& vacuous : engine::vacuous_expectations(campus, walk)) {
        const std::string what =
            vacuous.holds ? "' can't fail like this, whatever the walk does, which --strict "
                            "doesn't allow; expect something that can, or remove it"
                          : "' fails like this whatever the walk does, so the xfail can't be wrong, which "
                            "--strict doesn't allow; expect something that may hold one day";
        errors.push_back(refusal(vacuous.mark, "'" + vacuous.name + what));
    }
    return errors;
}

}  // namespace campuswalk::tools
