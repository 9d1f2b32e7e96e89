#include "scene/import/source/scene_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace campuswalk::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kImageSiblings = {"textures", "materials", "images", "maps"};

// Where exporters put images, in order of preference.
constexpr std::array<std::string_view, 6> kImageFolders = {
    "", "textures/", "images/", "../textures/", "../materials/textures/", "../images/"};

// Files and folders that are looked at for hidden ones.
constexpr std::size_t kMostSeen = 100'000;

/// Such folders hold no models but secrets: `.git/config` may have a token.
bool is_hidden(const fs::path& name) {
    return name.native().starts_with('.');
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    const int lower = std::tolower(static_cast<unsigned char>(c));
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string normalized_path(std::string_view uri) {
    constexpr std::string_view kScheme = "file://";
    if (uri.starts_with(kScheme)) {
        uri.remove_prefix(kScheme.size());
    }
    // PLY comments may end in a carriage return.
    uri = uri.substr(0, uri.find_last_not_of(" \t\r\n") + 1);
    std::string path(uri);
    std::ranges::replace(path, '\\', '/');
    return path;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> read_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = in ? static_cast<std::streamoff>(in.tellg()) : -1;
    if (size < 0) {
        return std::nullopt;
    }
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    in.seekg(0);
    in.read(reinterpret_cast<char*>(bytes.data()), size);
    return in ? std::optional(std::move(bytes)) : std::nullopt;
}

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string percent_decoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size()) {
            const int high = hex_digit(text[i + 1]);
            const int low = hex_digit(text[i + 2]);
            if (high >= 0 && low >= 0) {
                decoded += static_cast<char>(high * 16 + low);
                i += 2;
                continue;
            }
        }
        decoded += text[i];
    }
    return decoded;
}

namespace {

/// In the order of their names, so that the same are left out everywhere when there are too many.
std::vector<fs::directory_entry> sorted_contents(const fs::path& folder) {
    std::vector<fs::directory_entry> entries;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        entries.push_back(*it);
    }
    std::ranges::sort(entries);
    return entries;
}

/// Itself, not what a link leads to.
bool is_folder(const fs::directory_entry& entry) {
    std::error_code ignored;
    return !entry.is_symlink(ignored) && entry.is_directory(ignored);
}

/// Files and folders without anything hidden below, which together are all that isn't hidden.
class VisiblePaths {
public:
    void add_file(const fs::path& file) { paths_.push_back(file); }

    /// Adds only the files of the file system's root: with its folders, every file would be below it.
    void add_contents(const fs::path& folder) {
        Part part = visible_in(folder, folder == folder.root_path());
        std::ranges::move(part.paths, std::back_inserter(paths_));
    }

    std::vector<fs::path> take() { return std::move(paths_); }

private:
    struct Part {
        bool whole = true;  ///< nothing in the folder is hidden
        std::vector<fs::path> paths = {};
    };

    Part visible_in(const fs::path& folder, bool files_only = false) {
        Part part;
        std::vector<fs::path> folders;
        for (const fs::directory_entry& entry : sorted_contents(folder)) {
            const bool below = is_folder(entry);
            if (++seen_ > kMostSeen || is_hidden(entry.path().filename()) || (below && files_only)) {
                part.whole = false;
            } else {
                (below ? folders : part.paths).push_back(entry.path());
            }
        }
        for (const fs::path& path : folders) {
            Part below = visible_in(path);
            if (below.whole) {
                part.paths.push_back(path);
            } else {
                part.whole = false;
                std::ranges::move(below.paths, std::back_inserter(part.paths));
            }
        }
        return part;
    }

    std::vector<fs::path> paths_;
    std::size_t seen_ = 0;
};

}  // namespace

SceneFolder::SceneFolder(const SceneFile& file) : roots_(file.roots), images_beside_(file.images_beside) {
    std::error_code ignored;
    const fs::path folder = file.path.has_parent_path() ? file.path.parent_path() : fs::path(".");
    scene_file_ = fs::canonical(file.path, ignored);
    folder_ = fs::canonical(folder, ignored);
}

bool SceneFolder::may_read(const fs::path& resolved, bool image) const {
    if (folder_.empty()) {
        return false;
    }
    const auto below = [&](const fs::path& base) {
        const auto [in_base, in_path] =
            std::mismatch(base.begin(), base.end(), resolved.begin(), resolved.end());
        return in_base == base.end() && in_path != resolved.end() &&
               std::none_of(in_path, resolved.end(), is_hidden);
    };
    if (std::ranges::any_of(roots_, below)) {
        return true;
    }
    if (folder_ == folder_.root_path()) {  // else all files would be below it
        return resolved.parent_path() == folder_ && !is_hidden(resolved.filename());
    }
    if (below(folder_)) {
        return true;
    }
    const fs::path parent = folder_.parent_path();
    if (!image || !images_beside_ || !below(parent)) {
        return false;
    }
    const std::string sibling = lower_case(resolved.lexically_relative(parent).begin()->string());
    return std::ranges::find(kImageSiblings, sibling) != kImageSiblings.end();
}

std::vector<fs::path> SceneFolder::readable_paths() const {
    VisiblePaths visible;
    if (!scene_file_.empty()) {
        visible.add_file(scene_file_);
    }
    visible.add_contents(folder_);
    if (images_beside_) {
        for (const fs::directory_entry& entry : sorted_contents(folder_.parent_path())) {
            const std::string name = lower_case(entry.path().filename().string());
            if (std::ranges::find(kImageSiblings, name) != kImageSiblings.end() && is_folder(entry)) {
                visible.add_contents(entry.path());
            }
        }
    }
    for (const fs::path& root : roots_) {
        visible.add_contents(root);
    }
    return visible.take();
}

std::optional<fs::path> SceneFolder::try_path(const std::string& relative, bool image) const {
    const fs::path path(relative);
    if (relative.empty() || path.is_absolute() || relative.find('\0') != std::string::npos) {
        return std::nullopt;
    }
    std::error_code error;
    const fs::path resolved = fs::canonical(folder_ / path, error);
    if (error || !may_read(resolved, image) || !fs::is_regular_file(resolved, error)) {
        return std::nullopt;
    }
    return resolved;
}

void SceneFolder::record(std::string_view uri, bool image) const {
    FileRequest request{std::string(uri), image};
    if (std::ranges::find(*requests_, request) == requests_->end()) {
        requests_->push_back(std::move(request));
    }
}

std::optional<fs::path> SceneFolder::find_file(std::string_view uri) const {
    record(uri, false);
    const std::string path = normalized_path(uri);
    if (auto found = try_path(path, false)) {
        return found;
    }
    return try_path(percent_decoded(path), false);
}

std::optional<fs::path> SceneFolder::find_image(std::string_view uri) const {
    record(uri, true);
    const std::string path = normalized_path(uri);
    for (const std::string& name : {path, percent_decoded(path)}) {
        if (auto found = try_path(name, true)) {
            return found;
        }
        const std::string bare = name.substr(name.find_last_of('/') + 1);
        for (const std::string_view folder : kImageFolders) {
            if (bare.empty()) {
                break;
            }
            if (auto found = try_path(std::string(folder) + bare, true)) {
                return found;
            }
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::scene
