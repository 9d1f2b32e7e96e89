#pragma once

#include <optional>
#include <vector>

#include "scene/model/model_report.h"

namespace campuswalk::scene {

/// What the names of nodes promise and their sizes deny:
///   door-size    doors under 0.3 m or over 6 m high: a wrong unit; or lying on their backs: a wrong axis
///   stair-riser  stairs whose steps a visitor can't climb
/// `up`: the axis that seems to point up, 1 or 2; stairs are only looked at where it is 1.
std::vector<ModelLint> lint_named_sizes(const Model& model, const std::vector<NodeReport>& nodes, int up = 1);

/// Metres per unit by which the middle one of the doors would be 1.8 to 3.2 m high, if it is as high as no
/// door can be.
std::optional<double> scale_from_doors(const Model& model, const std::vector<NodeReport>& nodes);

/// The middle one of the steps between the heights of a flight's level faces; 0 for fewer than two.
double riser_of(std::vector<double> heights);

}  // namespace campuswalk::scene
