#pragma once

#include <string>
#include <vector>

#include "scene/lint/model_report.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

/// What was inferred and what it was inferred from, one per line: "+Z is up: 54 risers climb along it".
std::vector<std::string> frame_lines(const UprightModel& upright);

/// What is unsure, or contradicts what was typed:
///   z-up       it seems to lie on its back
///   odd-scale  what people build alike has another size in it
std::vector<scene::ModelLint> frame_lints(const UprightModel& upright);

/// "50.000 x 4.000 x 40.000 m".
std::string size_text(const Eigen::Vector3d& size, int digits);

/// A name of the kind in JSON: "facing", "risers", "doors".
const char* name_of(scene::UpVote::Kind kind);
const char* name_of(scene::Confidence confidence);

}  // namespace campuswalk::tools
