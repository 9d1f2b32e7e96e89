#pragma once

#include <string>

#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// The campus' models as reports show them (scene/export/write_glb.h), each node tagged with the objects that
/// it belongs to, packed by gzip. `error` in metres; 0: exact. Writing it takes as long as playing hundreds
/// of walks, so it is read from the cache of models if it was written before.
std::string packed_glb(const scene::Campus& campus, double error);

}  // namespace campuswalk::tools
