#pragma once

#include <functional>

#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

/// All that a program's main does: guards the standard streams, parses the command line, runs the chosen
/// command and turns exceptions into messages and exit codes. A process started by model_importer() serves
/// the import instead.
int run_program(int argc, char** argv, const ProgramName& name,
                const std::function<void(Command, CommandAction&)>& add_commands);

}  // namespace campuswalk::tools
