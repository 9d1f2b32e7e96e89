#include "config/loader/profile/profile_search.h"

#include <set>
#include <system_error>

#include "config/loader/values/folders_upwards.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

namespace {

/// Names of the profiles in all the folders, sorted.
std::vector<std::string> known_profiles(const ProfileKind& kind, const std::vector<fs::path>& folders) {
    std::set<std::string> names;
    for (const fs::path& folder : folders) {
        std::error_code ignored;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
            std::string name = entry.path().filename().string();
            if (name.ends_with(kind.suffix)) {
                name.resize(name.size() - std::string_view(kind.suffix).size());
                names.insert(std::move(name));
            }
        }
    }
    return {names.begin(), names.end()};
}

std::vector<fs::path> folders_to_search(const ProfileKind& kind, const ProfileFiles& files) {
    std::vector<fs::path> folders;
    for (const fs::path& above : folders_upwards(files.walk_folder)) {
        folders.push_back(above / kind.folder);
        folders.push_back(above / "config" / kind.folder);
    }
    folders.insert(folders.end(), files.more.begin(), files.more.end());
    return folders;
}

}  // namespace

std::optional<fs::path> find_profile(const ProfileKind& kind, const CheckedNode& node,
                                     const std::string& name, const ProfileFiles& files) {
    const std::vector<fs::path> folders = folders_to_search(kind, files);
    for (const fs::path& folder : folders) {
        fs::path file = folder / (name + kind.suffix);
        std::error_code ignored;
        if (fs::exists(file, ignored)) {
            return file;
        }
    }
    node.diagnose("unknown-name", "there is no " + name + kind.suffix + " in '" + kind.folder +
                                      "' or 'config/" + kind.folder +
                                      "' next to the walk or above it, nor among the program's own" +
                                      suggestion_or_list(name, known_profiles(kind, folders)));
    return std::nullopt;
}

}  // namespace campuswalk::config
