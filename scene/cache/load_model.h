#pragma once

#include "scene/base/content_hash.h"
#include "scene/cache/cache_folder.h"
#include "scene/model/scene_file.h"
#include "scene/import/import_model.h"

namespace campuswalk::scene {

struct LoadedModel {
    ImportedModel imported;
    /// Of everything that made it what it is: the bytes of all files that its import looked for, its settings
    /// and the program. None without a cache, or when the file was changed meanwhile.
    std::optional<ContentHash> contents;
};

/// What `importer` gives, or gave before with the same files, settings and program: then it isn't asked.
/// Mistakes are never kept: they are found anew. Without a cache (null) it is always asked.
LoadedModel load_model(const SceneFile& file, EmptyModel if_empty, const Importer& importer,
                       const CacheFolder* cache);

}  // namespace campuswalk::scene
