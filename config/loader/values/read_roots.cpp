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

bool begins_project(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder / "walks.config.yaml", ignored) || fs::exists(folder / ".git", ignored);
}

/// The first link on the way to the folder that is in a project or below the current folder; empty without
/// one.
fs::path link_in_project(const fs::path& folder) {
    std::error_code ignored;
    const fs::path current = fs::current_path(ignored);
    fs::path at;
    bool in_project = false;
    for (const fs::path& part : folder) {
        at /= part;
        if (in_project && fs::is_symlink(at, ignored)) {
            return at;
        }
        in_project = in_project || begins_project(at) || (at == current && at != at.root_path());
    }
    return {};
}

/// Seen from where the file is named, not from where a link of a project leads: that would be the link's
/// choice.
fs::path project_of(const fs::path& file) {
    std::error_code ignored;
    const fs::path folder = fs::absolute(file, ignored).lexically_normal().parent_path();
    if (const fs::path link = link_in_project(folder); !link.empty()) {
        return project_of(link);
    }
    const std::optional<unsigned> owner = owner_of(folder);
    for (fs::path at = folder; owner_of(at) == owner; at = at.parent_path()) {
        if (begins_project(at)) {
            return at;
        }
        if (at == at.parent_path()) {
            break;
        }
    }
    fs::path current = fs::current_path(ignored);
    return current != current.root_path() && below(current, folder) ? current : folder;
}

}  // namespace

ReadRoots::ReadRoots(const fs::path& file, const std::vector<fs::path>& more,
                     std::shared_ptr<ReadBudget> budget)
    : budget_(std::move(budget)) {
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
    return error ? "cannot be read: " + error.message() : why_canonical_unreadable(whole);
}

std::string ReadRoots::why_canonical_unreadable(const fs::path& file) const {
    bool hidden = false;
    for (const fs::path& root : roots_) {
        if (const std::optional<fs::path> rest = below(root, file)) {
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
