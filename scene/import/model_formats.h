#pragma once

#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// Who reads a format. A format that isn't on the list of those we have tried is refused: assimp would take
/// forty more, some of whose readers crash.
enum class Reader { gltf, assimp };

/// By the file's extension. Throws InputError bad-model, with what to do instead.
Reader reader_for(const SceneFile& file);

/// Throws InputError missing-file when the file isn't there or can't be read, bad-model for a PLY file that
/// ends in its header: assimp 5.2.5 never comes to an end of it.
void check_readable(const SceneFile& file);

}  // namespace campuswalk::scene
