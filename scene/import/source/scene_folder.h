#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/model_file.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// Which files a scene file may refer to. Models are untrusted: a URI such as `/etc/passwd` or `../../secret`
/// must not be read, nor a symbolic link that leads outside.
///   - any file in the scene file's folder or below, but for those in folders like `.git`;
///   - images also below a sibling of that folder named `textures`, `materials`, `images` or `maps` (in any
///     case), since the usual layout of simulators is `meshes/x.dae` and `materials/textures/x.png`; but not
///     without `images_beside`;
///   - any file below its `roots`, with the same exception: links may lead there.
/// Paths are compared after resolving symbolic links; only regular files are opened.
///
/// Lookups are recorded, successful or not, and shared among copies: the model depends on all of them.
class SceneFolder {
public:
    explicit SceneFolder(const SceneFile& file);

    /// The files and folders, with all below, that this allows to read, as far as they exist; the scene file
    /// itself wherever a link leads to it. None has anything below that is hidden. Only 100,000 files and
    /// folders are looked at for that, those of the scene's folder first; others are left out.
    std::vector<std::filesystem::path> readable_paths() const;

    /// Resolves a relative path; `\` means `/`, and if there is no such file, percent escapes are decoded.
    /// nullopt if the file is missing or outside, or the path is absolute.
    std::optional<std::filesystem::path> find_file(std::string_view uri) const;

    /// The same for an image. If it isn't there, its base name is looked up beside the scene and in the usual
    /// texture folders: exporters write absolute paths and bare names.
    std::optional<std::filesystem::path> find_image(std::string_view uri) const;

    /// Repeats a recorded lookup.
    std::optional<std::filesystem::path> find(const FileRequest& request) const {
        return request.image ? find_image(request.uri) : find_file(request.uri);
    }
    /// The lookups of all copies, unique, in the order of the first.
    const std::vector<FileRequest>& requests() const { return *requests_; }

private:
    void record(std::string_view uri, bool image) const;
    bool may_read(const std::filesystem::path& resolved, bool image) const;
    std::optional<std::filesystem::path> try_path(const std::string& relative, bool image) const;

    std::filesystem::path scene_file_;  ///< canonical; empty if it is missing
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> roots_;
    bool images_beside_;
    std::shared_ptr<std::vector<FileRequest>> requests_ = std::make_shared<std::vector<FileRequest>>();
};

/// The whole file; nullopt if it can't be read.
std::optional<std::vector<std::uint8_t>> read_bytes(const std::filesystem::path& path);

/// ASCII letters only.
std::string lower_case(std::string text);

/// `a%20b` to `a b`; malformed escapes are kept.
std::string percent_decoded(std::string_view text);

}  // namespace campuswalk::scene
