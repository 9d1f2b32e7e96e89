#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// Imports a campus of `lots` x `lots` lots (tools/campuswalk_bench/procedural/walkable_campus.h; 17 make 2
/// million triangles) from GLB files by our helper process, as every command does, and by assimp in this
/// process, with the steps that give the same data. Microseconds a triangle. Ours is wrong if it gives
/// another number of triangles. Then each of `models`, which may be anything that is read: what assimp does
/// of the same (join vertices, make normals) depends on the file, so it is timed with and without. It may
/// well find more or fewer triangles in them, for it passes over much of glTF and counts a mesh once that is
/// placed twice. Throws scene::InputError for one that isn't read.
CaseResult run_import_cases(int lots, int rounds, const std::vector<std::filesystem::path>& models);

/// What the peer does with the file: the number of triangles. `join`: give what has no normals flat ones, and
/// join equal vertices.
using ImportWithPeer = unsigned long (*)(const char* file, bool join);
inline constexpr const char* kImportWithPeer = "import_with_peer";

}  // namespace campuswalk::tools::bench
