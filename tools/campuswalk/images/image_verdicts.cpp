#include "tools/campuswalk/images/image_verdicts.h"

#include <optional>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/expect/failure_scene.h"
#include "engine/render/compare/compare_images.h"
#include "engine/render/image/png.h"
#include "engine/render/image/read_png.h"
#include "scene/base/atomic_file.h"
#include "scene/base/diagnostic.h"
#include "scene/base/glob.h"
#include "tools/campuswalk/base/read_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
namespace render = engine::render;

using engine::ExpectSnapshot;
using engine::ExpectVisible;

namespace {

std::string pixel_size_of(const render::Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// An image of this run beside its reference.
struct Comparison {
    render::Image actual;
    std::optional<render::Image> reference;  ///< nullopt if it can't be read
    std::string why;                         ///< they differ; empty: they don't
    std::optional<render::Image> difference;
};

Comparison compare(const fs::path& actual, const fs::path& reference,
                   const engine::ImageTolerance& tolerance) {
    Comparison comparison;
    comparison.actual = render::read_png(actual);
    try {
        comparison.reference = render::read_png(reference);
    } catch (const scene::InputError& error) {
        comparison.why = error.diagnostics().front().message;
        return comparison;
    }
    if (comparison.actual.width != comparison.reference->width ||
        comparison.actual.height != comparison.reference->height) {
        comparison.why = "it has " + pixel_size_of(comparison.actual) + " pixels, the golden image " +
                         pixel_size_of(*comparison.reference);
        return comparison;
    }
    const auto difference = render::compare_images(*comparison.reference, comparison.actual, tolerance);
    comparison.why = render::describe_violations(difference, tolerance);
    if (!comparison.why.empty()) {
        comparison.difference =
            render::draw_difference(*comparison.reference, comparison.actual, difference, tolerance);
    }
    return comparison;
}

class Evaluator {
public:
    explicit Evaluator(const ImageEvaluation& request) : request_(request) {}

    void evaluate(const ExpectSnapshot& expected) {
        remove_old_files(expected.name);
        if (request_.moments.taken(expected.name) == nullptr) {
            fail(expected.mark, engine::kSnapshotMissing, expected.name,
                 "the walk ended before it took the snapshot '" + expected.name + "'");
            return;
        }
        const fs::path actual = output_file(expected.name, "");
        const fs::path reference =
            reference_file(request_.walk_file, request_.walk.project, expected.name + ".png");
        std::error_code error;
        const bool missing = !fs::exists(reference, error);
        if (request_.update == UpdateSnapshots::all ||
            (missing && request_.update != UpdateSnapshots::none)) {
            update_reference(actual, reference);
            return;
        }
        if (missing) {
            fail(expected.mark, engine::kGoldenMissing, expected.name,
                 "there is no golden image '" + reference.string() +
                     "'; run with -u where you develop, and commit it");
            return;
        }
        const Comparison comparison =
            compare(actual, reference, engine::changed(request_.tolerance, expected.tolerance));
        if (!comparison.why.empty() && request_.update == UpdateSnapshots::changed) {
            update_reference(actual, reference);
        } else if (!comparison.why.empty()) {
            fail(expected.mark, comparison.reference ? ExpectSnapshot::kName : engine::kGoldenUnreadable,
                 expected.name,
                 "the snapshot '" + expected.name + "' differs from its golden image (" +
                     reference.filename().string() + "): " + comparison.why +
                     "; if this is intended, run with --update-snapshots=changed");
            save_comparison(expected.name, actual, reference, comparison);
        }
    }

    void evaluate(const ExpectVisible& expected) {
        if (request_.moments.taken(expected.snapshot) == nullptr) {
            fail(expected.mark, engine::kSnapshotMissing, expected.snapshot,
                 "the walk ended before it took the snapshot '" + expected.snapshot + "'");
            return;
        }
        const render::VisibleBuildings& visible = request_.visible_buildings.at(expected.snapshot);
        const std::size_t seen = pixels_of(expected.building.glob, visible);
        const double ratio = static_cast<double>(seen) / static_cast<double>(visible.pixels);
        const bool enough = seen >= static_cast<std::size_t>(expected.min_pixels) &&
                            (!expected.min_ratio || ratio >= *expected.min_ratio);
        if (enough == expected.negated) {
            fail(expected.mark, engine::code_of(expected), expected.snapshot,
                 std::to_string(seen) + (seen == 1 ? " pixel of '" : " pixels of '") +
                     expected.building.glob + (seen == 1 ? "' is" : "' are") + " visible in '" +
                     expected.snapshot + "' (" + engine::fixed(100.0 * ratio, 3) + " %)" +
                     expected_share(expected));
        }
    }

    // Nothing about images:
    void evaluate(const engine::PlainExpectation&) {}
    void evaluate(const engine::ExpectNot&) {}
    void evaluate(const engine::ExpectLog&) {}

    EvaluatedImages take() { return std::move(evaluated_); }

private:
    static std::string expected_share(const ExpectVisible& expected) {
        const char* least = expected.negated ? "less than " : "at least ";
        std::string words = std::string(", ") + least + std::to_string(expected.min_pixels);
        if (expected.min_ratio) {
            words += std::string(expected.negated ? " or " : " and ") + least +
                     engine::fixed(100.0 * *expected.min_ratio, 3) + " %";
        }
        return words + " expected";
    }

    std::size_t pixels_of(const std::string& glob, const render::VisibleBuildings& visible) const {
        std::size_t pixels = 0;
        for (std::size_t i = 0; i < visible.pixels_of_building.size(); ++i) {
            if (scene::glob_matches(glob, request_.campus.description.buildings[i].id)) {
                pixels += visible.pixels_of_building[i];
            }
        }
        return pixels;
    }

    fs::path output_file(const std::string& snapshot, const std::string& suffix) const {
        return request_.output / request_.folder / (snapshot + suffix + ".png");
    }

    /// Files of an earlier run would be mistaken for this one's.
    void remove_old_files(const std::string& snapshot) const {
        for (const char* suffix : {"-actual", "-expected", "-diff"}) {
            std::error_code ignored;
            fs::remove(output_file(snapshot, suffix), ignored);
        }
    }

    void update_reference(const fs::path& actual, const fs::path& reference) {
        evaluated_.updates.push_back({reference, read_bytes(actual)});
    }

    void fail(const scene::SourceMark& mark, std::string_view code, const std::string& snapshot,
              std::string message) {
        const engine::StateSnapshot* taken = request_.moments.taken(snapshot);
        evaluated_.failures.push_back({mark, std::string(code), std::move(message),
                                       engine::scene_of(taken != nullptr ? *taken : request_.moments.last(),
                                                        request_.campus, request_.walk.avatar)});
    }

    void save_comparison(const std::string& snapshot, const fs::path& actual, const fs::path& reference,
                         const Comparison& comparison) {
        scene::write_file_atomically(output_file(snapshot, "-actual"), read_bytes(actual));
        add_artifact(snapshot, "-actual");
        if (comparison.reference) {
            scene::write_file_atomically(output_file(snapshot, "-expected"), read_bytes(reference));
            add_artifact(snapshot, "-expected");
        }
        if (comparison.difference) {
            render::write_png(*comparison.difference, output_file(snapshot, "-diff"));
            add_artifact(snapshot, "-diff");
        }
    }

    void add_artifact(const std::string& snapshot, const std::string& suffix) {
        const std::string name = snapshot + suffix;
        evaluated_.artifacts.push_back({name, request_.folder + "/" + name + ".png", "image/png"});
    }

    const ImageEvaluation& request_;
    EvaluatedImages evaluated_;
};

}  // namespace

EvaluatedImages evaluate_images(const ImageEvaluation& request) {
    Evaluator evaluator(request);
    for (const engine::Expectation& expectation : request.walk.expectations) {
        std::visit([&](const auto& expected) { evaluator.evaluate(expected); }, expectation);
    }
    return evaluator.take();
}

}  // namespace campuswalk::tools
