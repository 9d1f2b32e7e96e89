#pragma once

#include <string>

#include "scene/campus/campus_description.h"
#include "tools/campuswalk/collide/print_overlaps.h"

namespace campuswalk::tools {

struct CollideOptions {
    std::string a;  ///< a model file or a shape, see collide/spelling.h
    std::string b;
    std::string pose;         ///< of b, see parse_pose; empty: where it is
    std::string pose_matrix;  ///< instead of `pose`
    scene::SceneFile frame;   ///< how files are to be read; which are a and b
    collide::Told told = collide::Told::all;
    bool json = false;
};

/// Holds two models or shapes against each other and prints where they overlap. Returns the exit code: kPass
/// when they are apart, kOverlapping when not.
int collide_bodies(const CollideOptions& options);

}  // namespace campuswalk::tools
