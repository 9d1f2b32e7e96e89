#include "config/loader/values/folders_upwards.h"

#include <sys/stat.h>

#include <system_error>

namespace campuswalk::config {

namespace fs = std::filesystem;

std::optional<unsigned> owner_of(const fs::path& folder) {
    struct stat status {};
    return stat(folder.c_str(), &status) == 0 ? std::optional<unsigned>(status.st_uid) : std::nullopt;
}

std::vector<fs::path> folders_upwards(const fs::path& folder) {
    std::vector<fs::path> folders;
    std::error_code ignored;
    fs::path at = folder.empty() ? fs::path(".") : folder;
    const std::optional<unsigned> owner = owner_of(at);
    for (fs::path whole = fs::weakly_canonical(at, ignored); owner_of(at) == owner;
         whole = whole.parent_path()) {
        folders.push_back(at);
        if (fs::exists(at / ".git", ignored) || whole == whole.parent_path()) {
            break;
        }
        at /= "..";
    }
    return folders;
}

}  // namespace campuswalk::config
