#pragma once

#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

enum class Shell { bash, zsh, fish };

/// Prints the script that completes these commands in a shell. Returns the exit code.
int print_completion(const KnownCommand& program, Shell shell);

}  // namespace campuswalk::tools
