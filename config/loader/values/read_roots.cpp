#include "config/loader/values/read_roots.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "config/loader/values/folders_upwards.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

namespace {

/// The path as seen from the folder; nullopt if it isn't there or below.
std::optional<fs::path> below(const fs::path& folder, const fs::path& path) {
    const auto [in_folder, in_path] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    if (in_folder != folder.end()) {
        return std::nullopt;
    }
    fs::path rest;
    for (auto part = in_path; part != path.end(); ++part) {
        rest /= *part;
    }
    return rest;
}

bool is_hidden(const fs::path& name) {
    return name.native().starts_with('.');
}

/// Seen from where the file is named, not from where a link leads: that would be the link's choice. So a
/// project that a link of another project leads to doesn't count.
fs::path project_of(const fs::path& file) {
    std::error_code ignored;
    const fs::path folder = fs::absolute(file, ignored).lexically_normal().parent_path();
    const std::optional<unsigned> owner = owner_of(folder);
    fs::path nearest;
    fs::path beyond_a_link;
    for (fs::path at = folder; owner_of(at) == owner; at = at.parent_path()) {
        const bool begins =
            fs::is_regular_file(at / "walks.config.yaml", ignored) || fs::exists(at / ".git", ignored);
        if (begins && nearest.empty()) {
            nearest = at;
        }
        if (fs::is_symlink(at, ignored) && !nearest.empty()) {
            beyond_a_link = std::exchange(nearest, fs::path());
        }
        if (at == at.parent_path()) {
            break;
        }
    }
    if (!nearest.empty()) {
        return nearest;
    }
    fs::path current = fs::current_path(ignored);
    if (current != current.root_path() && below(current, folder)) {
        return current;
    }
    return beyond_a_link.empty() ? folder : beyond_a_link;
}

}  // namespace

ReadRoots::ReadRoots(const fs::path& file, const std::vector<fs::path>& more) {
    std::error_code ignored;
    roots_.push_back(fs::weakly_canonical(project_of(file), ignored));
    for (const fs::path& root : more) {
        roots_.push_back(fs::weakly_canonical(root, ignored));
    }
}

std::string ReadRoots::why_unreadable(const fs::path& file) const {
    std::error_code error;
    const fs::path written = fs::absolute(file, error);
    const fs::path whole = error ? written : fs::weakly_canonical(written, error);
    if (error) {
        return "cannot be read: " + error.message();
    }
    bool hidden = false;
    for (const fs::path& root : roots_) {
        if (const std::optional<fs::path> rest = below(root, whole)) {
            const fs::path folders = rest->parent_path();
            if (std::none_of(folders.begin(), folders.end(), is_hidden)) {
                return "";
            }
            hidden = true;
        }
    }
    return hidden ? "is in a folder whose name starts with '.'; such folders aren't read"
                  : "leads out of the project; move it there, or name its folder with --root";
}

}  // namespace campuswalk::config
