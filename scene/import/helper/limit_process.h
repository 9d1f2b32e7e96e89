#pragma once

#include "scene/import/helper/import_protocol.h"

namespace campuswalk::scene {

/// Limits what this process may use from now on (but for the time on the clock, which its parent watches),
/// and ends it with its parent.
void limit_process(const ImportLimits& limits);

}  // namespace campuswalk::scene
