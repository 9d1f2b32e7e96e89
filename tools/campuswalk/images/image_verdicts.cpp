#include "tools/campuswalk/images/image_verdicts.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/expect/failure_scene.h"
#include "engine/render/compare/compare_images.h"
#include "engine/render/image/png.h"
#include "engine/render/image/read_png.h"
#include "scene/base/atomic_file.h"
#include "scene/base/diagnostic.h"
#include "scene/base/glob.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
namespace render = engine::render;

using engine::ExpectSnapshot;
using engine::ExpectVisible;

namespace {

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        throw std::runtime_error("can't read '" + file.string() + "'");
    }
    return bytes;
}

std::string pixel_size_of(const render::Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// An image of this run and the one that was kept.
struct Pair {
    render::Image actual;
    std::optional<render::Image> kept;  ///< none: it can't be read
    std::string why;                    ///< they differ; empty: they don't
    std::optional<render::Image> difference;
};

Pair compare(const fs::path& actual, const fs::path& kept, const engine::ImageTolerance& tolerance) {
    Pair pair;
    pair.actual = render::read_png(actual);
    try {
        pair.kept = render::read_png(kept);
    } catch (const scene::InputError& error) {
        pair.why = error.diagnostics().front().message;
        return pair;
    }
    if (pair.actual.width != pair.kept->width || pair.actual.height != pair.kept->height) {
        pair.why =
            "it has " + pixel_size_of(pair.actual) + " pixels, the kept one " + pixel_size_of(*pair.kept);
        return pair;
    }
    const auto comparison = render::compare_images(*pair.kept, pair.actual, tolerance);
    pair.why = render::describe_violations(comparison, tolerance);
    if (!pair.why.empty()) {
        pair.difference = render::draw_difference(*pair.kept, pair.actual, comparison, tolerance);
    }
    return pair;
}

class Evaluation {
public:
    explicit Evaluation(const ImageEvaluation& trial) : trial_(trial) {}

    void evaluator(const ExpectSnapshot& expected) {
        clean_up(expected.name);
        if (trial_.moments.taken(expected.name) == nullptr) {
            fail(expected.mark, std::string(ExpectSnapshot::kName), expected.name,
                 "the walk ended before it took the snapshot '" + expected.name + "'");
            return;
        }
        const fs::path actual = own_file(expected.name, "");
        const fs::path kept = cached_file(trial_.walk_file, trial_.walk.project, expected.name + ".png");
        std::error_code error;
        const bool missing = !fs::exists(kept, error);
        if (trial_.update == UpdateSnapshots::all || (missing && trial_.update != UpdateSnapshots::none)) {
            keep(actual, kept);
            return;
        }
        if (missing) {
            fail(expected.mark, std::string(ExpectSnapshot::kName), expected.name,
                 "there is no kept picture '" + kept.string() +
                     "' yet; run with --update-snapshots=missing where you develop, and commit it");
            return;
        }
        const Pair pair = compare(actual, kept, engine::changed(trial_.tolerance, expected.tolerance));
        if (!pair.why.empty() && trial_.update == UpdateSnapshots::changed) {
            keep(actual, kept);
        } else if (!pair.why.empty()) {
            fail(expected.mark, std::string(ExpectSnapshot::kName), expected.name,
                 "the snapshot '" + expected.name + "' is not the kept one (" + kept.filename().string() +
                     "): " + pair.why + "; if that is meant, run with --update-snapshots=changed");
            show(expected.name, actual, kept, pair);
        }
    }

    void evaluator(const ExpectVisible& expected) {
        if (trial_.moments.taken(expected.snapshot) == nullptr) {
            fail(expected.mark, engine::code_of(expected), expected.snapshot,
                 "the walk ended before it took the snapshot '" + expected.snapshot + "'");
            return;
        }
        const render::VisibleBuildings& sight = trial_.visible_buildings.at(expected.snapshot);
        const std::size_t seen = pixels_of(expected.building.glob, sight);
        const double ratio = static_cast<double>(seen) / static_cast<double>(sight.pixels);
        const bool enough = seen >= static_cast<std::size_t>(expected.min_pixels) &&
                            (!expected.min_ratio || ratio >= *expected.min_ratio);
        if (enough == expected.negated) {
            fail(expected.mark, engine::code_of(expected), expected.snapshot,
                 std::string(expected.negated ? "not expected, but " : "") + "of '" + expected.building.glob +
                     "' " + std::to_string(seen) + (seen == 1 ? " pixel is" : " pixels are") +
                     " to be seen in '" + expected.snapshot + "' (" + engine::fixed(100.0 * ratio, 3) +
                     " %)" + wanted(expected));
        }
    }

    template <typename Other>
    void evaluator(const Other& /*nothing about images*/) {}

    EvaluatedImages take() { return std::move(evaluated_); }

private:
    static std::string wanted(const ExpectVisible& expected) {
        const char* least = expected.negated ? "less than " : "at least ";
        std::string words = std::string(", ") + least + std::to_string(expected.min_pixels);
        if (expected.min_ratio) {
            words += std::string(expected.negated ? " or " : " and ") + least +
                     engine::fixed(100.0 * *expected.min_ratio, 3) + " %";
        }
        return words + " expected";
    }

    std::size_t pixels_of(const std::string& glob, const render::VisibleBuildings& sight) const {
        std::size_t pixels = 0;
        for (std::size_t i = 0; i < sight.pixels_of_building.size(); ++i) {
            if (scene::glob_matches(glob, trial_.campus.description.buildings[i].id)) {
                pixels += sight.pixels_of_building[i];
            }
        }
        return pixels;
    }

    fs::path own_file(const std::string& snapshot, const std::string& which) const {
        return trial_.output / trial_.folder / (snapshot + which + ".png");
    }

    /// What an earlier run left would be taken for this one's.
    void clean_up(const std::string& snapshot) const {
        for (const char* which : {"-actual", "-expected", "-diff"}) {
            std::error_code ignored;
            fs::remove(own_file(snapshot, which), ignored);
        }
    }

    void keep(const fs::path& actual, const fs::path& kept) {
        scene::write_file_atomically(kept, bytes_of(actual));
        evaluated_.written.push_back(kept);
    }

    void fail(const scene::SourceMark& mark, std::string code, const std::string& snapshot,
              std::string message) {
        const engine::StateSnapshot* taken = trial_.moments.taken(snapshot);
        evaluated_.failures.push_back({mark, std::move(code), std::move(message),
                                       engine::scene_of(taken != nullptr ? *taken : trial_.moments.last(),
                                                        trial_.campus, trial_.walk.avatar)});
    }

    void show(const std::string& snapshot, const fs::path& actual, const fs::path& kept, const Pair& pair) {
        scene::write_file_atomically(own_file(snapshot, "-actual"), bytes_of(actual));
        tell_of(snapshot, "-actual");
        if (pair.kept) {
            scene::write_file_atomically(own_file(snapshot, "-expected"), bytes_of(kept));
            tell_of(snapshot, "-expected");
        }
        if (pair.difference) {
            render::write_png(*pair.difference, own_file(snapshot, "-diff"));
            tell_of(snapshot, "-diff");
        }
    }

    void tell_of(const std::string& snapshot, const std::string& which) {
        const std::string name = snapshot + which;
        evaluated_.artifacts.push_back({name, trial_.folder + "/" + name + ".png", "image/png"});
    }

    const ImageEvaluation& trial_;
    EvaluatedImages evaluated_;
};

}  // namespace

EvaluatedImages evaluate_images(const ImageEvaluation& trial) {
    Evaluation evaluation(trial);
    for (const engine::Expectation& expectation : trial.walk.expectations) {
        std::visit([&](const auto& expected) { evaluation.evaluator(expected); }, expectation);
    }
    return evaluation.take();
}

}  // namespace campuswalk::tools
