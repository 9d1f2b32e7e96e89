#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/import/helper/import_protocol.h"

namespace campuswalk::scene {

/// A program that calls serve_import when it is started with these arguments.
struct HelperProgram {
    std::filesystem::path program;
    std::vector<std::string> arguments;  ///< without the program's name
};

/// Runs import_model in a child process, so that an untrusted model can't crash this one. A helper that
/// crashes, exceeds a limit, can't have the sandbox that SandboxMode::require demands, or sends an invalid
/// response leads to InputError bad-model; one that can't be started, to std::runtime_error.
Importer import_in_process(HelperProgram helper, ImportLimits limits = {},
                           SandboxMode sandbox = SandboxMode::automatic);

}  // namespace campuswalk::scene
