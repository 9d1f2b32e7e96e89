#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// Imports a campus of `lots` x `lots` lots (tools/campuswalk_bench/procedural/walkable_campus.h; 17 make 2
/// million triangles) from GLB files by our helper process, as every command does, and by assimp in this
/// process, with the steps that produce the same data. Microseconds per triangle. Ours is wrong if its number
/// of triangles differs. Then each of `models`, in any format that we read: which of these steps (joining
/// vertices, generating normals) are equivalent depends on the file, so assimp is timed with and without
/// them. Its number of triangles may differ, because it ignores much of glTF and counts a mesh that is placed
/// twice only once. Throws scene::InputError for a model that can't be read.
CaseResult run_import_cases(int lots, int rounds, const std::vector<std::filesystem::path>& models);

/// Reads the file and returns the number of triangles. `join`: generate missing normals (flat), and join
/// equal vertices.
using ImportWithPeer = unsigned long (*)(const char* file, bool join);
inline constexpr const char* kImportWithPeer = "import_with_peer";

}  // namespace campuswalk::tools::bench
