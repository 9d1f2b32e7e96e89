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

/// import_model in a process of its own, started with posix_spawn: the models of strangers can crash it, not
/// this one. A helper that crashes, runs into a limit or answers what is no model gives InputError bad-model;
/// one that can't be started std::runtime_error.
Importer import_in_process(HelperProgram helper, ImportLimits limits = {});

}  // namespace campuswalk::scene
