#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/base/diagnostic.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// A file that an import looked for beside the scene, found or not: what the model depends on besides the
/// scene file itself. Asked again of a SceneFolder it gives the same file.
struct FileRequest {
    std::string uri;     ///< as the scene names it
    bool image = false;  ///< looked for as images are (SceneFolder::find_image)

    friend bool operator==(const FileRequest&, const FileRequest&) = default;
};

/// All that an import gives.
struct ImportedModel {
    Model model;
    std::vector<Diagnostic> warnings;
    std::vector<FileRequest> requests;  ///< in the order they were first made, without repeats
};

/// Raise it with whatever changes below, in `Model`, or in what an import makes of the same files.
inline constexpr FileKind kModelFile = {{'c', 'w', ' ', 'm', 'o', 'd', 'e', 'l'}, 4};

/// An imported model as the bytes of a file, yet to be sealed: what is large in it is left where it is.
ArchiveWriter archive_model(const ImportedModel& imported);

/// An imported model as bytes, and back to the bit: how the import's helper process hands it over, and how
/// the cache keeps it. Floats are stored as they lie in memory.
std::vector<std::byte> write_model_file(const ImportedModel& imported);

/// Reads bytes that may be anything; what it returns keeps all that `Model` promises: indices are in range,
/// parents come before children, transforms and positions are finite, textures have all their pixels.
/// Throws DamagedFile; memory is bounded by a small multiple of the bytes. With an `owner` that keeps the
/// bytes as they are, meshes and images are used where they lie in them; without, they are copied.
ImportedModel read_model_file(std::span<const std::byte> bytes, std::shared_ptr<const void> owner = nullptr);

}  // namespace campuswalk::scene
