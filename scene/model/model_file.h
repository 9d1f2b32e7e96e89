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

/// A file that an import looked up besides the scene file itself, found or not: a dependency of the model.
/// SceneFolder::find() repeats the lookup.
struct FileRequest {
    std::string uri;     ///< as written in the scene
    bool image = false;  ///< looked up by SceneFolder::find_image

    friend bool operator==(const FileRequest&, const FileRequest&) = default;
};

/// The result of an import.
struct ImportedModel {
    Model model;
    std::vector<Diagnostic> warnings;
    std::vector<FileRequest> requests;  ///< unique, in the order of the first lookup
};

/// Increment the version whenever the layout, `Model`, or the result of importing the same file changes.
inline constexpr FileKind kModelFile = {{'c', 'w', ' ', 'm', 'o', 'd', 'e', 'l'}, 6};

/// Serializes an imported model. Large arrays are not copied: `imported` must outlive the writer.
ArchiveWriter archive_model(const ImportedModel& imported);

/// The inverse, to the bit; used for the response of the import process and for the cache. Accepts untrusted
/// bytes and validates what `Model` guarantees: indices are in range, parents precede children, transforms
/// and positions are finite, textures have all their pixels. Throws DamagedFile; allocates at most a small
/// multiple of the bytes. With an `owner` (see ArchiveReader), meshes and images refer to the bytes instead
/// of copying.
ImportedModel read_model_file(std::span<const std::byte> bytes, std::shared_ptr<const void> owner = nullptr);

}  // namespace campuswalk::scene
