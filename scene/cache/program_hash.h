#pragma once

#include "scene/base/content_hash.h"

namespace campuswalk::scene {

/// Of the running program's own file: what another build left in the cache is never used, whoever forgot to
/// raise a version. The same for all programs where the system doesn't say which file that is.
const ContentHash& program_hash();

}  // namespace campuswalk::scene
