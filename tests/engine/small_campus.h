#pragma once

#include <string>

#include "collision/world/world.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// The properties of an object besides its shape and place.
struct ObjectTraits {
    collision::Detection detection = collision::Detection::solid;
    std::string building;  ///< id of the owner, empty for none
    bool popup = true;     ///< has an effect only with a building
    std::string layer;     ///< empty for none
};

/// A campus without objects, named "small".
scene::Campus empty_campus();

/// A level floor at y = 0, called "ground": a solid mesh, a square with sides of 2 `half_size` about the
/// origin.
scene::Campus level_campus(double half_size = 50.0, collision::TreeKind tree = collision::TreeKind::bvh8);

/// A level floor of 12 m x 12 m within walls of 4 m, about the origin.
scene::Campus walled_yard();

/// A level floor with a wall of 3 m across the way north, 3 m from the origin.
scene::Campus walled_campus();

/// Appends a building with an information record.
void add_building(scene::Campus& campus, const std::string& id, const std::string& title = "",
                  const std::string& hours = "", const std::string& text = "");

/// Adds an unrotated shape centred at `center`. A new layer is appended to the campus' layers.
collision::ObjectId add_object(scene::Campus& campus, const std::string& id, const collision::Shape& shape,
                               const Eigen::Vector3d& center, const ObjectTraits& traits = {});

/// Adds an axis-aligned box.
collision::ObjectId add_box(scene::Campus& campus, const std::string& id, const Eigen::Vector3d& min,
                            const Eigen::Vector3d& max, const ObjectTraits& traits = {});

}  // namespace campuswalk::engine
