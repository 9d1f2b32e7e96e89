#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"
#include "scene/import/import_model.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

struct LoadedModel {
    ImportedModel imported;
    /// The hash of everything that the model depends on: all files that the import looked up, the settings,
    /// the program. nullopt without a cache, or if the file changed during the import.
    std::optional<ContentHash> contents;
    std::vector<std::filesystem::path> files;  ///< those that it was read from; the scene file first
};

/// The result of `importer`, or the cached result of an earlier import of the same files with the same
/// settings and program. Errors are not cached. Without a cache (null), always imports.
LoadedModel load_model(const SceneFile& file, EmptyModel if_empty, const Importer& importer,
                       const CacheFolder* cache);

/// Only the files that the model is read from, the scene file first. A cache that knows them spares the
/// import. Throws what the importer throws.
std::vector<std::filesystem::path> files_of_model(const SceneFile& file, EmptyModel if_empty,
                                                  const Importer& importer, const CacheFolder* cache);

}  // namespace campuswalk::scene
