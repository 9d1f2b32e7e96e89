#pragma once

#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// The reader of a format. Only formats that we have tested are accepted: assimp has forty more, and some of
/// its readers crash.
enum class Reader { gltf, assimp };

/// By the file's extension. Throws InputError bad-model for others, with what to do instead.
Reader reader_for(const SceneFile& file);

/// Throws InputError missing-file if the file doesn't exist or can't be read, and bad-model for a PLY file
/// that ends inside its header: assimp 5.2.5 loops forever on it.
void check_readable(const SceneFile& file);

}  // namespace campuswalk::scene
