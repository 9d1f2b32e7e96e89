#include "tools/campuswalk/suggest/upright_model.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/model/name_words.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/suggest/frame_text.h"
#include "tools/campuswalk/suggest/lint_text.h"

namespace campuswalk::tools {

using Eigen::Vector3d;

bool has_lint(const scene::ModelReport& report, scene::DiagnosticCode code) {
    return std::ranges::any_of(report.warnings,
                               [&](const scene::ModelLint& lint) { return lint.code == code; });
}

namespace {

/// Takes skies and operands out of the model: they would hide the rest on maps, and close doorways.
std::vector<scene::IntangibleNode> take_intangible(scene::Model& model) {
    std::vector<scene::IntangibleNode> intangible = scene::intangible_nodes(model);
    for (const scene::IntangibleNode& each : intangible) {
        if (each.kind != scene::IntangibleNode::Kind::water) {
            model.nodes[each.node].meshes.clear();
        }
    }
    return intangible;
}

void report_on(UprightModel& upright) {
    upright.report = scene::report(upright.model);
    std::vector<scene::ModelLint> lints = frame_lints(upright);
    std::ranges::move(intangible_lints(upright), std::back_inserter(lints));
    scene::add_repairs(upright.repairs, upright.report);
    upright.report.warnings.insert(upright.report.warnings.begin(), lints.begin(), lints.end());
}

}  // namespace

UprightModel load_upright(const scene::SceneFile& file, const TypedFrame& typed, scene::EmptyModel if_empty) {
    UprightModel upright;
    upright.file = file;
    scene::LoadedModel loaded = read_model(file, if_empty);
    upright.intangible = take_intangible(loaded.imported.model);
    upright.frame = scene::guess_frame(loaded.imported.model);
    const scene::FrameGuess& frame = upright.frame;
    upright.is_turned = !typed.up && file.up == scene::UpAxis::y && frame.up == scene::UpAxis::z &&
                        frame.up_confidence == scene::Confidence::sure;
    upright.is_scaled =
        !typed.scale && frame.scale != 1.0 && frame.scale_confidence == scene::Confidence::sure;
    if (upright.is_turned || upright.is_scaled) {
        upright.file.up = upright.is_turned ? scene::UpAxis::z : file.up;
        upright.file.scale *= upright.is_scaled ? frame.scale : 1.0;
        loaded = read_model(upright.file, if_empty);
        upright.intangible = take_intangible(loaded.imported.model);
    }
    upright.model = std::move(loaded.imported.model);
    upright.files = std::move(loaded.files);
    upright.repairs = std::move(loaded.imported.warnings);
    report_on(upright);
    return upright;
}

Vector3d move_near(UprightModel& upright) {
    if (!has_lint(upright.report, "far-from-origin")) {
        return Vector3d::Zero();
    }
    const scene::Bounds& bounds = upright.report.bounds;
    Vector3d middle = bounds.center();
    middle.y() = bounds.min.y();
    Vector3d origin = middle.array().round();
    scene::move_origin(upright.model, origin);
    report_on(upright);
    return origin;
}

bool is_intangible(const UprightModel& upright, std::size_t node) {
    return std::ranges::find(upright.intangible, node, &scene::IntangibleNode::node) !=
           upright.intangible.end();
}

std::vector<std::string> closed_door_names(const scene::ModelReport& report) {
    std::vector<std::string> names;
    for (const scene::Door& door : report.doors) {
        const std::string& name = report.nodes[door.node].name;
        const bool is_new = std::ranges::find(names, name) == names.end();
        if (door.is_closed && scene::is_door_name(name) && is_new) {
            names.push_back(name);
        }
    }
    return names;
}

}  // namespace campuswalk::tools
