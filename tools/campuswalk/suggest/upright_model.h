#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/campus/campus_description.h"
#include "scene/lint/model_report.h"
#include "scene/model/model.h"

namespace campuswalk::tools {

/// A model the way it should stand: turned upright, with doors as high as doors, and near the origin.
struct UprightModel {
    scene::SceneFile file;
    std::vector<scene::Model> models;  ///< one
    scene::ModelReport report;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< what was taken off its coordinates
};

/// Throws scene::InputError, as the import does.
UprightModel load_upright(const scene::SceneFile& file);

/// Whether it has a lint of that code.
bool has_lint(const scene::ModelReport& report, const std::string& code);

/// The names of doors that close a way through, of those that are called doors; each once.
std::vector<std::string> closed_door_names(const scene::ModelReport& report);

}  // namespace campuswalk::tools
