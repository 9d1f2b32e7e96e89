#include "tools/campuswalk/run/plan/strict_rules.h"

#include <string>
#include <variant>

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

}  // namespace campuswalk::tools
