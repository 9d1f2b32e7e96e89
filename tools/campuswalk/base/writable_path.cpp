#include "tools/campuswalk/base/writable_path.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

std::string refusal(const fs::path& path, int mode) {
    return access(path.c_str(), mode) == 0
               ? ""
               : "'" + path.string() + "': " + std::generic_category().message(errno);
}

/// The path itself, or the nearest folder above it that there is.
fs::path nearest_existing(fs::path path) {
    std::error_code none;
    while (!path.empty() && !fs::exists(path, none)) {
        path = path.has_relative_path() ? path.parent_path() : fs::path();
    }
    return path.empty() ? fs::path(".") : path;
}

}  // namespace

std::string why_folder_unwritable(const fs::path& folder) {
    const fs::path nearest = nearest_existing(folder);
    std::error_code none;
    return fs::is_directory(nearest, none) ? refusal(nearest, W_OK | X_OK)
                                           : "'" + nearest.string() + "' is not a folder";
}

std::string why_file_unwritable(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) {
        return "it is a folder; name a file";
    }
    if (fs::exists(status)) {
        return refusal(file, W_OK);
    }
    if (status.type() != fs::file_type::not_found) {
        return error.message();
    }
    return why_folder_unwritable(file.parent_path());
}

void require_writable_image(const fs::path& file) {
    if (const std::string why = why_file_unwritable(file); !why.empty()) {
        throw scene::InputError({file.string(), 0, 0}, "output-unwritable",
                                "the picture can't be written here: " + why);
    }
}

}  // namespace campuswalk::tools
