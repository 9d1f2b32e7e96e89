#include "tools/campuswalk/suggest/upright_model.h"

#include <algorithm>

#include "scene/lint/named_sizes.h"
#include "scene/model/name_words.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/suggest/ground_lint.h"

namespace campuswalk::tools {

using Eigen::Vector3d;

bool has_lint(const scene::ModelReport& report, scene::DiagnosticCode code) {
    return std::ranges::any_of(report.warnings,
                               [&](const scene::ModelLint& lint) { return lint.code == code; });
}

UprightModel load_upright(const scene::SceneFile& file) {
    UprightModel upright{file, {}, {}, Vector3d::Zero()};
    std::vector<scene::Diagnostic> repairs;
    for (int turn = 0; turn < 3; ++turn) {
        scene::ImportedModel imported = read_model(upright.file, scene::EmptyModel::refuse).imported;
        upright.report = scene::report(imported.model);
        upright.models.clear();
        upright.models.push_back(std::move(imported.model));
        repairs = std::move(imported.warnings);
        if (has_lint(upright.report, "z-up") && upright.file.up == scene::UpAxis::y) {
            upright.file.up = scene::UpAxis::z;
        } else if (const auto scale = scene::scale_from_doors(upright.models[0], upright.report.nodes)) {
            upright.file.scale *= *scale;
        } else {
            break;
        }
    }
    if (has_lint(upright.report, "far-from-origin")) {
        const scene::Bounds& bounds = upright.report.bounds;
        Vector3d middle = bounds.center();
        middle.y() = bounds.min.y();
        upright.origin = middle.array().round();
        scene::move_origin(upright.models[0], upright.origin);
        upright.report = scene::report(upright.models[0]);
    }
    lint_ground(ground_of(upright.models[0], upright.report), upright.report);
    scene::add_repairs(repairs, upright.report);
    return upright;
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
