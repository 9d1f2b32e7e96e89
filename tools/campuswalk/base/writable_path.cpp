#include "tools/campuswalk/base/writable_path.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

std::string refusal(const fs::path& path, int mode) {
    return access(path.c_str(), mode) == 0
               ? ""
               : "'" + path.string() + "': " + std::generic_category().message(errno);
}

/// The path itself, or the nearest folder above it that exists.
fs::path nearest_existing(fs::path path) {
    std::error_code ignored;
    while (!path.empty() && !fs::exists(path, ignored)) {
        path = path.has_relative_path() ? path.parent_path() : fs::path();
    }
    return path.empty() ? fs::path(".") : path;
}

bool is_link(const fs::path& path) {
    std::error_code ignored;
    return fs::is_symlink(path, ignored);
}

/// Whether somebody else's files may be in the folder and below.
bool begins_a_project(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / ".git", ignored) || fs::exists(folder / "walks.config.yaml", ignored) ||
           (folder == fs::current_path(ignored) && folder != folder.root_path());
}

/// Absolute, and the same with and without a '/' at its end.
fs::path plain(const fs::path& path) {
    std::error_code ignored;
    const fs::path normal = fs::absolute(path, ignored).lexically_normal();
    return normal.has_filename() || !normal.has_relative_path() ? normal : normal.parent_path();
}

/// The first link that the path leads through below a project, or below `named`; empty without one. From the
/// root downwards: a link's target could begin a project of its own.
fs::path link_in(const fs::path& path, const fs::path& named = {}) {
    const fs::path top = named.empty() ? fs::path() : plain(named);
    fs::path prefix;
    bool below = false;
    for (const fs::path& part : plain(path)) {
        prefix /= part;
        if (below && is_link(prefix)) {
            return prefix;
        }
        below = below || prefix == top || begins_a_project(prefix);
    }
    return {};
}

/// Why a file that is there can't be replaced.
std::string refusal_of_file(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_other(file, ignored)) {
        return "it is a pipe, a socket or a device; remove it, or name another file";
    }
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (fs::hard_link_count(file, ignored) > 1 && access(folder.c_str(), W_OK | X_OK) != 0) {
        return "it has another name (a hard link), and its folder can't be changed; name another file";
    }
    return refusal(file, W_OK);
}

std::string refusal_of_links(const fs::path& path, const fs::path& named) {
    const fs::path link = link_in(path, named);
    return link.empty() ? "" : "'" + link.filename().string() + "' is a symbolic link";
}

void throw_if_any(const std::string& obstacle, const fs::path& path, const std::string& message) {
    if (!obstacle.empty()) {
        throw error_about(path, "output-unwritable", message + ": " + obstacle);
    }
}

}  // namespace

bool leads_through_link(const fs::path& path) {
    return !link_in(path).empty();
}

std::string why_folder_unwritable(const fs::path& folder, const fs::path& named) {
    if (std::string why = refusal_of_links(folder, named); !why.empty()) {
        return why;
    }
    const fs::path nearest = nearest_existing(folder);
    std::error_code ignored;
    return fs::is_directory(nearest, ignored) ? refusal(nearest, W_OK | X_OK)
                                              : "'" + nearest.string() + "' is not a folder";
}

std::string why_file_unwritable(const fs::path& file, const fs::path& named) {
    if (std::string why = refusal_of_links(file, named); !why.empty()) {
        return why;
    }
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) {
        return "it is a folder; name a file";
    }
    if (fs::exists(status)) {
        return refusal_of_file(file);
    }
    if (status.type() != fs::file_type::not_found) {
        return error.message();
    }
    return why_folder_unwritable(file.parent_path(), named);
}

void require_writable_file(const fs::path& file, const std::string& message, const fs::path& named) {
    throw_if_any(why_file_unwritable(file, named), file, message);
}

void require_writable_png(const fs::path& file, const std::string& message) {
    if (file.has_extension() && file.extension() != ".png") {
        throw error_about(
            file, "file-name",
            "pictures are PNG files; name it " + fs::path(file).replace_extension(".png").string());
    }
    require_writable_file(file, message);
}

void require_writable_folder(const fs::path& folder, const std::string& message, const fs::path& named) {
    const fs::path& top = named.empty() ? folder : named;
    throw_if_any(why_folder_unwritable(folder, top), folder, message);
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        throw_if_any(refusal_of_links(entry.path(), top), entry.path(), message);
        if (entry.is_other(ignored)) {
            throw_if_any(refusal_of_file(entry.path()), entry.path(), message);
        }
    }
}

void require_no_input(const fs::path& file, const std::vector<fs::path>& inputs, const std::string& purpose) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) {
        return;
    }
    for (const fs::path& input : inputs) {
        if (fs::equivalent(file, input, ignored)) {
            throw error_about(file, "report-unwritable",
                              "this would replace a file that " + purpose + "; name another");
        }
    }
}

}  // namespace campuswalk::tools
