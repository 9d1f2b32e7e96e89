#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/frame/guess_frame.h"
#include "scene/import/import_model.h"
#include "scene/lint/intangible_nodes.h"
#include "scene/lint/model_report.h"
#include "scene/model/model.h"
#include "scene/model/scene_file.h"

namespace campuswalk::tools {

/// What the user has typed of a model's frame, which is never changed.
struct TypedFrame {
    bool up = false;
    bool scale = false;
};

/// A model with the upper axis and the unit that its geometry and names are sure of.
struct UprightModel {
    scene::SceneFile file;
    scene::Model model;
    std::vector<std::filesystem::path> files;       ///< that it was read from
    std::vector<scene::Diagnostic> repairs;         ///< by the import
    std::vector<scene::IntangibleNode> intangible;  ///< all but waters have no triangles in `model`
    scene::ModelReport report;  ///< with what the import repaired and what is unsure about the frame
    scene::FrameGuess frame;    ///< of the file with what was typed
    bool is_turned = false;     ///< as `frame` says
    bool is_scaled = false;
};

/// Throws scene::InputError, as the import does.
UprightModel load_upright(const scene::SceneFile& file, const TypedFrame& typed, scene::EmptyModel if_empty);

/// Moves a model that is far from the world's origin near it. Returns what was subtracted from its
/// coordinates.
Eigen::Vector3d move_near(UprightModel& upright);

/// Whether there is a lint with this code.
bool has_lint(const scene::ModelReport& report, scene::DiagnosticCode code);

/// Whether the node is one of the model's intangible ones.
bool is_intangible(const UprightModel& upright, std::size_t node);

/// The names of the nodes that are called doors and close a doorway, each once.
std::vector<std::string> closed_door_names(const scene::ModelReport& report);

}  // namespace campuswalk::tools
