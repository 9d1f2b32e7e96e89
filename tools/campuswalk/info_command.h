#pragma once

#include "scene/campus_description.h"

namespace campuswalk::tools {

struct InfoOptions {
    scene::SceneFile scene;
    bool json = false;
};

/// Prints what is in a model file and what looks odd about it. Returns the exit code.
int print_info(const InfoOptions& options);

}  // namespace campuswalk::tools
