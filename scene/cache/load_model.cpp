#include "scene/cache/load_model.h"

#include <optional>
#include <utility>

#include "scene/base/binary_archive.h"
#include "scene/cache/file_contents.h"
#include "scene/cache/program_hash.h"
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
ContentHash key_of(const SceneFile& file, EmptyModel if_empty, const ContentHash& contents) {
    ContentHasher hasher;
    hasher.add_hash(program_hash());
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

/// Adds the current results of the lookups: an import with the same results gives the same model.
ContentHash key_with_files(const ContentHash& key, const SceneFile& file, const ContentHash& contents,
                           const std::vector<FileRequest>& requests) {
    ContentHasher hasher;
    hasher.add_hash(key);
    const SceneFolder folder(file.path);
    std::error_code ignored;
    for (const FileRequest& request : requests) {
        hasher.add_text(request.uri);
        hasher.add_number(std::uint64_t{request.image});
        const std::optional<std::filesystem::path> found = folder.find(request);
        const bool itself = found && std::filesystem::equivalent(*found, file.path, ignored);
        const auto hash = itself ? contents : found ? hash_of_file(*found) : std::nullopt;
        hasher.add_number(std::uint64_t{hash.has_value()});
        hasher.add_hash(hash.value_or(ContentHash{}));
    }
    return hasher.result();
}

std::vector<std::filesystem::path> files_of(const SceneFile& file, const std::vector<FileRequest>& requests) {
    std::vector<std::filesystem::path> files = {file.path};
    const SceneFolder folder(file.path);
    for (const FileRequest& request : requests) {
        if (const std::optional<std::filesystem::path> found = folder.find(request)) {
            files.push_back(*found);
        }
    }
    return files;
}

std::optional<LoadedModel> find_model(const SceneFile& file, const ContentHash& key,
                                      const ContentHash& contents, const CacheFolder& cache) {
    try {
        const auto requests_file = cache.find(key, kRequestsKind);
        if (!requests_file) {
            return std::nullopt;
        }
        const std::vector<FileRequest> requests = read_requests(requests_file->bytes());
        const ContentHash model_key = key_with_files(key, file, contents, requests);
        const auto cached = cache.find(model_key, kModelKind);
        if (!cached) {
            return std::nullopt;
        }
        LoadedModel loaded{read_model_file(cached->bytes(), cached), model_key, files_of(file, requests)};
        for (Diagnostic& warning : loaded.imported.warnings) {
            warning.mark = file.mark;  // the file may be named on another line now
        }
        return loaded;
    } catch (const DamagedFile&) {
        return std::nullopt;  // treated as a miss
    }
}

LoadedModel imported(const SceneFile& file, EmptyModel if_empty, const Importer& importer) {
    ImportedModel model = importer(file, if_empty);
    std::vector<std::filesystem::path> files = files_of(file, model.requests);
    return {std::move(model), std::nullopt, std::move(files)};
}

LoadedModel import_and_cache(const SceneFile& file, EmptyModel if_empty, const Importer& importer,
                             const CacheFolder& cache, const ContentHash& contents) {
    LoadedModel loaded = imported(file, if_empty, importer);
    const ContentHash key = key_of(file, if_empty, contents);
    if (hash_of_file(file.path) == contents) {  // it didn't change meanwhile
        loaded.contents = key_with_files(key, file, contents, loaded.imported.requests);
        ArchiveWriter model = archive_model(loaded.imported);
        cache.store(*loaded.contents, kModelKind, model.finish());
        ArchiveWriter requests = archive_requests(loaded.imported.requests);
        cache.store(key, kRequestsKind, requests.finish());
    }
    return loaded;
}

}  // namespace

LoadedModel load_model(const SceneFile& file, EmptyModel if_empty, const Importer& importer,
                       const CacheFolder* cache) {
    const std::optional<ContentHash> contents = cache != nullptr ? hash_of_file(file.path) : std::nullopt;
    if (!contents) {
        return imported(file, if_empty, importer);  // an unreadable file is its error
    }
    const ContentHash key = key_of(file, if_empty, *contents);
    if (std::optional<LoadedModel> cached = find_model(file, key, *contents, *cache)) {
        return std::move(*cached);
    }
    return import_and_cache(file, if_empty, importer, *cache, *contents);
}

}  // namespace campuswalk::scene
