#include "config/loader/avatar_search.h"

#include <set>
#include <system_error>

#include "config/loader/wording.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSuffix = ".avatar.yaml";
constexpr int kMostParents = 8;

/// Names of the profiles in all the folders, sorted.
std::vector<std::string> known_avatars(const std::vector<fs::path>& folders) {
    std::set<std::string> names;
    for (const fs::path& folder : folders) {
        std::error_code none;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
            std::string name = entry.path().filename().string();
            if (name.ends_with(kSuffix)) {
                name.resize(name.size() - std::string_view(kSuffix).size());
                names.insert(std::move(name));
            }
        }
    }
    return {names.begin(), names.end()};
}

}  // namespace

std::vector<fs::path> avatar_folders(const fs::path& walk_folder, const std::vector<fs::path>& more) {
    std::vector<fs::path> folders;
    fs::path parent = walk_folder.empty() ? fs::path(".") : walk_folder;
    for (int i = 0; i <= kMostParents; ++i) {
        folders.push_back(parent / "avatars");
        folders.push_back(parent / "config" / "avatars");
        parent /= "..";
    }
    folders.insert(folders.end(), more.begin(), more.end());
    return folders;
}

std::optional<fs::path> find_avatar(const CheckedNode& node, const std::string& name,
                                    const std::vector<fs::path>& folders) {
    for (const fs::path& folder : folders) {
        fs::path file = folder / (name + kSuffix);
        std::error_code none;
        if (fs::exists(file, none)) {
            return file;
        }
    }
    node.complain("unknown-name",
                  "there is no " + name + kSuffix +
                      " in 'avatars' or 'config/avatars' beside the walk, above it or with the program" +
                      suggestion_or_list(name, known_avatars(folders)));
    return std::nullopt;
}

}  // namespace campuswalk::config
