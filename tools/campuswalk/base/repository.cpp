#include "tools/campuswalk/base/repository.h"

#include <algorithm>
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

fs::path checkout_above(const fs::path& folder, const Environment& environment) {
    std::error_code ignored;
    // Many keep their settings under version control; a CI machine has no such home.
    const fs::path home =
        is_ci(environment) ? fs::path() : fs::weakly_canonical(environment("HOME").value_or("/"), ignored);
    for (fs::path at = fs::weakly_canonical(fs::absolute(folder, ignored), ignored); at != at.parent_path();
         at = at.parent_path()) {
        const bool is_checkout =
            fs::exists(at / ".git", ignored) || fs::exists(at / "walks.config.yaml", ignored);
        if (is_checkout && at != home) {
            return at;
        }
    }
    return {};
}

}  // namespace campuswalk::tools
