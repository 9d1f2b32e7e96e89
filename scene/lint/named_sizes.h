#pragma once

#include <optional>
#include <vector>

#include "scene/lint/model_report.h"

namespace campuswalk::scene {

/// Compares the sizes of doors and stairs with what their names imply:
///   door-size    doors under 0.3 m or over 6 m high (wrong unit), or lying flat (wrong up axis)
///   odd-scale    stairs with risers that would be a stair's in centimetres or millimetres
///   stair-riser  stairs with risers too high to climb
/// `up`: the presumed up axis, 1 or 2; risers too high to climb are reported only if it is 1.
std::vector<ModelLint> lint_named_sizes(const Model& model, const std::vector<NodeReport>& nodes, int up = 1);

/// If the median height of the doors is implausible: the metres per unit that would make it 1.8 to 3.2 m.
std::optional<double> scale_from_doors(const Model& model, const std::vector<NodeReport>& nodes);

/// The median difference between the heights of a flight's treads; 0 for fewer than two risers.
double riser_of(std::vector<double> heights);

}  // namespace campuswalk::scene
