#pragma once

#include "scene/import/helper/helper_exchange.h"
#include "scene/import/helper/import_protocol.h"

namespace campuswalk::scene {

/// Runs import_model in a child process, a program that calls serve_import, so that an untrusted model can't
/// crash this one. A helper that crashes, exceeds a limit, can't have the sandbox that SandboxMode::require
/// demands, or sends an invalid response leads to InputError bad-model; one that can't be started, to
/// std::runtime_error.
Importer import_in_process(HelperProgram helper, ImportLimits limits = {},
                           SandboxMode sandbox = SandboxMode::automatic);

}  // namespace campuswalk::scene
