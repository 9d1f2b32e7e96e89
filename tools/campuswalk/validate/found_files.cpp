#include "tools/campuswalk/validate/found_files.h"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>
#include <utility>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, FileKind>, 6> kEndings = {{
    {".walk.yaml", FileKind::walk},
    {".campus.yaml", FileKind::campus},
    {".avatar.yaml", FileKind::avatar},
    {".light.yaml", FileKind::light},
    {".steps.yaml", FileKind::steps},
    {".config.yaml", FileKind::config},
}};

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (auto entry = fs::recursive_directory_iterator(folder, options, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code none;
        if (entry->is_directory(none) && entry->path().filename().string().starts_with('.')) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file(none) && kind_of(entry->path())) {
            files.push_back(entry->path().lexically_normal());
        }
    }
    std::ranges::sort(files, {}, [](const fs::path& file) { return file.generic_string(); });
    if (files.empty()) {
        throw scene::InputError(
            {folder.string(), 0, 0}, "no-files",
            "there is no NAME.walk.yaml, .campus.yaml, .avatar.yaml, .light.yaml, .steps.yaml "
            "or walks.config.yaml in this folder");
    }
    return files;
}

}  // namespace

std::optional<FileKind> kind_of(const fs::path& file) {
    const std::string name = file.filename().string();
    for (const auto& [ending, kind] : kEndings) {
        if (name.ends_with(ending)) {
            return kind;
        }
    }
    return std::nullopt;
}

std::vector<fs::path> found_files(const fs::path& path) {
    std::error_code none;
    return fs::is_directory(path, none) ? files_below(path) : std::vector{path};
}

}  // namespace campuswalk::tools
