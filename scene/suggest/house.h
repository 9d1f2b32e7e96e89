#pragma once

#include <optional>
#include <vector>

#include "scene/model/model.h"
#include "scene/model/upright_box.h"
#include "scene/suggest/structures.h"

namespace campuswalk::scene {

/// The box around structures if together they are a house: they rise over 2.2 m, cover 12 m² and 2 m across
/// and more of the box than a triangle does, and there are walls near at least three of the box's four sides,
/// of 30 % of the area that walls of one storey all around would have, and some of them in the lowest storey.
/// `most` is the largest footprint, m².
std::optional<UprightBox> house_of(const Model& model, const std::vector<const Structure*>& structures,
                                   double most);

/// How much of the smaller of two boxes' plans is in the other one's: 0 to 1, in ninths.
double shared_plan(const UprightBox& a, const UprightBox& b);

}  // namespace campuswalk::scene
