#pragma once

#include <string>

#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// Empty if packed bytes announce what they can plausibly hold, else what is wrong with them. Draco allocates
/// memory for all that they announce before it reads any of it. Other damage is for the decoder to find.
std::string why_draco_too_large(Bytes packed);

}  // namespace campuswalk::scene::gltf
