#pragma once

#include "scene/import/helper/import_protocol.h"

namespace campuswalk::scene {

/// The first argument of a program that is started as import helper.
inline constexpr const char* kImportHelperArgument = "import-helper";

/// The main function of the helper: reads the request from standard input, limits its resources, imports, and
/// writes the response to standard output; both are files. Returns the exit code, 0 if there is a response.
int serve_import();

/// Limits the resources of this process, except wall clock time, which the parent watches.
void limit_process(const ImportLimits& limits);

}  // namespace campuswalk::scene
