#pragma once

#include <vector>

#include "scene/lint/model_report.h"

namespace campuswalk::scene {

/// Compares the sizes of doors and stairs with what their names imply:
///   door-size    doors under 0.3 m or over 6 m high (wrong unit), or lying flat (wrong up axis)
///   stair-riser  stairs with risers too high to climb
std::vector<ModelLint> lint_named_sizes(const Model& model, const std::vector<NodeReport>& nodes);

/// The median difference between the heights of a flight's treads; 0 for fewer than two risers.
double riser_of(std::vector<double> heights);

}  // namespace campuswalk::scene
