#include "scene/cache/load_model.h"

#include <utility>

#include "scene/base/binary_archive.h"
#include "scene/cache/file_hash.h"
#include "scene/import/source/scene_folder.h"
#include "scene/model/model_file.h"

namespace campuswalk::scene {
namespace {

constexpr const char* kModelKind = "model";
/// The lookups of an import: read first, since the model's key depends on their results.
constexpr const char* kRequestsKind = "requests";
constexpr FileKind kRequestsFile = {{'c', 'w', ' ', 'f', 'i', 'l', 'e', 's'}, 1};

ArchiveWriter archive_requests(const std::vector<FileRequest>& requests) {
    ArchiveWriter out(kRequestsFile);
    out.put(std::uint64_t{requests.size()});
    for (const FileRequest& request : requests) {
        out.put_text(request.uri);
        out.put(std::uint32_t{request.image});
    }
    return out;
}

std::vector<FileRequest> read_requests(std::span<const std::byte> bytes) {
    constexpr std::size_t kMinRequestBytes = 12;
    ArchiveReader in(bytes, kRequestsFile);
    std::vector<FileRequest> requests(in.take_count(kMinRequestBytes));
    for (FileRequest& request : requests) {
        request.uri = in.take_text();
        request.image = in.take_flag();
    }
    in.finish();
    return requests;
}

/// The hash of the scene file, its settings and the program.
ContentHash key_of(const SceneFile& file, EmptyModel if_empty, const ContentHash& contents,
                   const CacheFolder& cache) {
    ContentHasher hasher;
    hasher.add_hash(program_hash(&cache));
    hasher.add_number(std::uint64_t{kModelFile.version});
    hasher.add_text(file.file);  // part of the model and its warnings
    hasher.add_text(file.path.filename().string());
    hasher.add_number(static_cast<std::uint64_t>(file.up));
    hasher.add_number(file.metres_per_unit);
    hasher.add_number(file.scale);
    for (const double along : {file.position.x(), file.position.y(), file.position.z()}) {
        hasher.add_number(along);
    }
    hasher.add_number(static_cast<std::uint64_t>(if_empty));
    hasher.add_hash(contents);
    return hasher.result();
}

/// What the lookups of an import find now, in their order.
using FoundFiles = std::vector<std::optional<std::filesystem::path>>;

FoundFiles find_files(const SceneFile& file, const std::vector<FileRequest>& requests) {
    const SceneFolder folder(file);
    FoundFiles found;
    found.reserve(requests.size());
    for (const FileRequest& request : requests) {
        found.push_back(folder.find(request));
    }
    return found;
}

/// Adds the current results of the lookups: an import with the same results gives the same model.
ContentHash key_with_files(const ContentHash& key, const SceneFile& file, const ContentHash& contents,
                           const std::vector<FileRequest>& requests, const FoundFiles& files,
                           const CacheFolder& cache) {
    ContentHasher hasher;
    hasher.add_hash(key);
    std::error_code ignored;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        hasher.add_text(requests[i].uri);
        hasher.add_number(std::uint64_t{requests[i].image});
        const bool itself = files[i] && std::filesystem::equivalent(*files[i], file.path, ignored);
        const auto hash = itself ? contents : files[i] ? hash_of_file(*files[i], &cache) : std::nullopt;
        hasher.add_number(std::uint64_t{hash.has_value()});
        hasher.add_hash(hash.value_or(ContentHash{}));
    }
    return hasher.result();
}

std::vector<std::filesystem::path> with_scene(const SceneFile& file, const FoundFiles& found) {
    std::vector<std::filesystem::path> files = {file.path};
    for (const std::optional<std::filesystem::path>& each : found) {
        if (each) {
            files.push_back(*each);
        }
    }
    return files;
}

/// What an import of the same file with the same settings looked up; nullopt if the cache doesn't know.
std::optional<std::vector<FileRequest>> find_requests(const ContentHash& key, const CacheFolder& cache) {
    const auto requests_file = cache.find(key, kRequestsKind);
    return requests_file ? std::optional(read_requests(requests_file->bytes())) : std::nullopt;
}

std::optional<LoadedModel> find_model(const SceneFile& file, const ContentHash& key,
                                      const ContentHash& contents, const CacheFolder& cache) {
    try {
        const std::optional<std::vector<FileRequest>> requests = find_requests(key, cache);
        if (!requests) {
            return std::nullopt;
        }
        const FoundFiles found = find_files(file, *requests);
        const ContentHash model_key = key_with_files(key, file, contents, *requests, found, cache);
        const auto cached = cache.find(model_key, kModelKind);
        if (!cached) {
            return std::nullopt;
        }
        LoadedModel loaded{read_model_file(cached->bytes(), cached), model_key, with_scene(file, found)};
        for (Diagnostic& warning : loaded.imported.warnings) {
            warning.mark = file.mark;  // the file may be named on another line now
        }
        return loaded;
    } catch (const DamagedFile&) {
        return std::nullopt;  // treated as a miss
    }
}

LoadedModel import_and_cache(const SceneFile& file, EmptyModel if_empty, const Importer& importer,
                             const CacheFolder* cache, const std::optional<ContentHash>& contents) {
    ImportedModel model = importer(file, if_empty);
    const FoundFiles found = find_files(file, model.requests);
    LoadedModel loaded{std::move(model), std::nullopt, with_scene(file, found)};
    if (cache != nullptr && contents && hash_of_file(file.path, nullptr) == contents) {  // it didn't change
        const ContentHash key = key_of(file, if_empty, *contents, *cache);
        const std::vector<FileRequest>& requests = loaded.imported.requests;
        loaded.contents = key_with_files(key, file, *contents, requests, found, *cache);
        ArchiveWriter archive = archive_model(loaded.imported);
        cache->store(*loaded.contents, kModelKind, archive.finish());
        ArchiveWriter lookups = archive_requests(requests);
        cache->store(key, kRequestsKind, lookups.finish());
    }
    return loaded;
}

}  // namespace

LoadedModel load_model(const SceneFile& file, EmptyModel if_empty, const Importer& importer,
                       const CacheFolder* cache) {
    std::optional<ContentHash> contents;
    if (cache != nullptr) {
        contents =
            hash_of_file(file.path, cache);  // none of an unreadable file, which is the importer's error
    }
    if (contents) {
        const ContentHash key = key_of(file, if_empty, *contents, *cache);
        if (std::optional<LoadedModel> cached = find_model(file, key, *contents, *cache)) {
            return std::move(*cached);
        }
    }
    return import_and_cache(file, if_empty, importer, cache, contents);
}

std::vector<std::filesystem::path> files_of_model(const SceneFile& file, EmptyModel if_empty,
                                                  const Importer& importer, const CacheFolder* cache) {
    const std::optional<ContentHash> contents =
        cache != nullptr ? hash_of_file(file.path, cache) : std::nullopt;
    if (contents) {
        try {
            if (const auto requests = find_requests(key_of(file, if_empty, *contents, *cache), *cache)) {
                return with_scene(file, find_files(file, *requests));
            }
        } catch (const DamagedFile&) {  // treated as a miss
        }
    }
    return load_model(file, if_empty, importer, cache).files;
}

}  // namespace campuswalk::scene
