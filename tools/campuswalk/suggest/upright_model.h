#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/campus/campus_description.h"
#include "scene/lint/model_report.h"
#include "scene/model/model.h"

namespace campuswalk::tools {

/// A model as it should stand: turned upright, scaled so that doors are as high as doors, near the origin.
struct UprightModel {
    scene::SceneFile file;
    std::vector<scene::Model> models;  ///< one
    scene::ModelReport report;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< what was subtracted from its coordinates
};

/// Throws scene::InputError, as the import does.
UprightModel load_upright(const scene::SceneFile& file);

/// Whether there is a lint with this code.
bool has_lint(const scene::ModelReport& report, scene::DiagnosticCode code);

/// The names of the nodes that are called doors and close a doorway, each once.
std::vector<std::string> closed_door_names(const scene::ModelReport& report);

}  // namespace campuswalk::tools
