#pragma once

#include <string>

#include "scene/campus/campus_description.h"
#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

/// How model files are to be read that nothing else describes; `whose` ends the descriptions.
void add_file_frame(Command command, scene::SceneFile& file, const std::string& whose);

}  // namespace campuswalk::tools
