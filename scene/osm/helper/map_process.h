#pragma once

#include "scene/import/helper/helper_exchange.h"
#include "scene/import/helper/sandbox.h"
#include "scene/osm/helper/map_files.h"

namespace campuswalk::scene::osm {

/// The first argument of a program that is started as map helper.
inline constexpr const char* kMapHelperArgument = "map-helper";

/// Imports a map in a child process with limits, which can read the map and its heights and do nothing else.
/// `helper` calls serve_map. Throws InputError as import_map does, and bad-map for a helper that crashes or
/// exceeds a limit; std::runtime_error for one that can't be started.
MapFiles import_map_in_process(const HelperProgram& helper, const MapRequest& request,
                               const ImportLimits& limits, SandboxMode sandbox);

/// The main function of the helper: reads the request from standard input and writes the response to standard
/// output; both are files. Returns only without a response, with the exit code.
int serve_map();

}  // namespace campuswalk::scene::osm
