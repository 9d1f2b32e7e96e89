#pragma once

#include "tools/campuswalk/command_line/command.h"
#include "tools/campuswalk/rendering_backend.h"

namespace campuswalk::tools {

/// `--rendering-backend`, for a command that draws.
void add_rendering_backend(Command& command, Backend& backend);

}  // namespace campuswalk::tools
