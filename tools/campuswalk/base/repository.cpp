#include "tools/campuswalk/base/repository.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

bool is_same_or_above(const fs::path& folder, const fs::path& other) {
    return std::ranges::mismatch(folder, other).in1 == folder.end();
}

std::optional<fs::path> root_above(const fs::path& here, const Environment& environment) {
    std::error_code ignored;
    for (const char* variable : {"GITHUB_WORKSPACE", "CI_PROJECT_DIR"}) {
        if (const std::optional<std::string> value = environment(variable)) {
            const fs::path root = fs::canonical(*value, ignored);  // empty if there is none
            if (!root.empty() && is_same_or_above(root, here)) {
                return root;
            }
        }
    }
    for (fs::path folder = here;; folder = folder.parent_path()) {
        if (fs::exists(folder / ".git", ignored)) {
            return folder;
        }
        if (folder == folder.parent_path()) {
            return std::nullopt;
        }
    }
}

}  // namespace

std::string start_in_repository(const Environment& environment) {
    std::error_code error;
    const fs::path here = fs::current_path(error);
    if (error) {
        return "";
    }
    const std::optional<fs::path> root = root_above(here, environment);
    return !root || *root == here ? "" : here.lexically_relative(*root).generic_string();
}

}  // namespace campuswalk::tools
