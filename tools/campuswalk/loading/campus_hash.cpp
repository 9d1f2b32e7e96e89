#include "tools/campuswalk/loading/campus_hash.h"

#include "scene/cache/file_hash.h"

namespace campuswalk::tools {

using scene::ContentHash;

std::optional<ContentHash> hash_of_campus(const scene::Campus& campus,
                                          const std::filesystem::path& campus_file,
                                          const scene::CacheFolder& cache) {
    const std::optional<ContentHash> file = scene::hash_of_file(campus_file, &cache);
    if (!file || campus.contents.size() != campus.models.size()) {
        return std::nullopt;
    }
    scene::ContentHasher hasher;
    hasher.add_hash(scene::program_hash(&cache));
    hasher.add_hash(*file);
    for (const std::filesystem::path& places : campus.description.place_files) {
        const std::optional<ContentHash> hash = scene::hash_of_file(places, &cache);
        if (!hash) {
            return std::nullopt;
        }
        hasher.add_hash(*hash);
    }
    for (const ContentHash& model : campus.contents) {
        hasher.add_hash(model);
    }
    return hasher.result();
}

}  // namespace campuswalk::tools
