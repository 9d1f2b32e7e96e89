#pragma once

#include "scene/cache/content_hash.h"

namespace campuswalk::scene {

/// The hash of the running executable. It keeps builds from using each other's cache entries, even if a
/// version was not incremented. Zero if the system doesn't tell which file it is.
const ContentHash& program_hash();

}  // namespace campuswalk::scene
