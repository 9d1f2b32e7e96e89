#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/model_file.h"

namespace campuswalk::scene {

/// Which files a scene file may draw in. A model is data from strangers: a buffer URI of `/etc/passwd` or
/// `../../secret` must not be read, nor what a symbolic link in its folder points to elsewhere.
///   - anything: at or below the scene file's own folder;
///   - images only: also below a sibling of that folder called `textures`, `materials`, `images` or `maps`
///     (any case), because the usual layout of simulators is `meshes/x.dae` + `materials/textures/x.png`.
/// Paths are compared after symbolic links are resolved; only regular files are opened.
///
/// What it was asked for is kept, found or not, and shared by its copies: all of it decides what the model
/// is.
class SceneFolder {
public:
    explicit SceneFolder(const std::filesystem::path& scene_file);

    /// A file named by the scene: a relative path, `%20` decoded when the plain name isn't there, `\` read as
    /// `/`. nullopt when it is missing, absolute or outside.
    std::optional<std::filesystem::path> find_file(std::string_view uri) const;

    /// Likewise for an image; when it isn't where the scene says (absolute paths of another machine, bare
    /// names), its bare name is looked for beside the scene and in the usual texture folders.
    std::optional<std::filesystem::path> find_image(std::string_view uri) const;

    /// One of the two, as the request says.
    std::optional<std::filesystem::path> find(const FileRequest& request) const {
        return request.image ? find_image(request.uri) : find_file(request.uri);
    }
    /// What it and its copies were asked for, in the order of the first time, without repeats.
    const std::vector<FileRequest>& requests() const { return *requests_; }

private:
    void keep_request(std::string_view uri, bool image) const;
    bool may_read(const std::filesystem::path& resolved, bool image) const;
    std::optional<std::filesystem::path> try_path(const std::string& relative, bool image) const;

    std::filesystem::path folder_;
    std::shared_ptr<std::vector<FileRequest>> requests_ = std::make_shared<std::vector<FileRequest>>();
};

/// `a%20b` to `a b`; malformed escapes stay as they are.
std::string percent_decoded(std::string_view text);

}  // namespace campuswalk::scene
