#include "tools/campuswalk/base/canonical_paths.h"

#include <system_error>

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

fs::path followed(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

}  // namespace

fs::path CanonicalPaths::of(const fs::path& file) {
    const fs::path name = file.filename();
    std::error_code ignored;
    if (name.empty() || name == "." || name == ".." || fs::is_symlink(file, ignored)) {
        return followed(file);
    }
    const auto [folder, is_new] = folders_.try_emplace(file.parent_path());
    if (is_new) {
        folder->second = followed(folder->first.empty() ? "." : folder->first);
    }
    return folder->second / name;
}

}  // namespace campuswalk::tools
