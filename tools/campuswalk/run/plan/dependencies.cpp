#include "tools/campuswalk/run/plan/dependencies.h"

#include <string>
#include <system_error>

#include "config/loader/load_run.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/run/plan/find_walks.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

Dependencies::Dependencies(const RunSettings& settings) {
    std::error_code ignored;
    output_ = fs::absolute(settings.output, ignored);
    for (const fs::path& path : settings.paths) {
        fs::is_directory(path, ignored) ? add_folders_below(path) : add_folder(path.parent_path());
    }
    if (!settings.config.empty()) {
        add_folder(settings.config.parent_path());
    }
    WalkLoader loader;
    for (const fs::path& walk : find_walks(settings.paths)) {
        for (const char* profiles : {"avatars", "config/avatars", "lights", "config/lights"}) {
            add_folder(walk.parent_path() / profiles);
        }
        for (const config::ProjectConfig& project : settings.projects) {
            add_walk(loader, walk, project.overrides);
        }
    }
}

void Dependencies::add_folder(const fs::path& folder) {
    std::error_code ignored;
    const fs::path there = folder.empty() ? fs::path(".") : folder.lexically_normal();
    if (fs::is_directory(there, ignored)) {
        folders_.insert(there);
    }
}

void Dependencies::add_folders_below(const fs::path& folder) {
    std::error_code ignored;
    add_folder(folder);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const bool is_output = name.ends_with("-snapshots") || fs::absolute(entry.path(), ignored) == output_;
        if (entry.is_directory(ignored) && !entry.is_symlink(ignored) && name.front() != '.' && !is_output) {
            add_folders_below(entry.path());
        }
    }
}

void Dependencies::add_dependency(const fs::path& walk, const fs::path& file) {
    add_folder(file.parent_path());
    walks_by_file_[file.lexically_normal()].insert(walk);
}

void Dependencies::add_walk(WalkLoader& loader, const fs::path& walk, const config::Overrides& overrides) {
    add_dependency(walk, walk);
    try {
        const config::Run run = loader.read(walk, overrides);
        add_dependency(walk, run.walk.campus);
        for (const fs::path& profile : run.profiles) {
            add_dependency(walk, profile);
        }
        for (const scene::SceneFile& scene : run.campus->scenes) {
            add_folder(scene.path.parent_path());
            walks_by_model_folder_[scene.path.lexically_normal().parent_path()].insert(walk);
        }
        for (const fs::path& file : run.walk.included) {
            add_dependency(walk, file);
        }
    } catch (const scene::InputError&) {
        walks_with_errors_.insert(walk);  // the run reports the errors
    }
}

Dependencies::Paths Dependencies::walks_of_model_at(const fs::path& file) const {
    for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
        if (const auto known = walks_by_model_folder_.find(folder); known != walks_by_model_folder_.end()) {
            return known->second;
        }
        if (folder == folder.parent_path()) {
            return {};
        }
    }
}

std::vector<fs::path> Dependencies::walks_of(const std::set<fs::path>& changed) const {
    std::error_code ignored;
    Paths walks = walks_with_errors_;
    for (const fs::path& file : changed) {
        Paths users;
        if (const auto known = walks_by_file_.find(file); known != walks_by_file_.end()) {
            users = known->second;
        } else if (file.string().ends_with(config::kWalkSuffix)) {
            users = {file};
        } else if (file.extension() != ".yaml") {
            users = walks_of_model_at(file);
        }
        if (users.empty() || !fs::exists(file, ignored)) {
            return {};
        }
        walks.insert(users.begin(), users.end());
    }
    return {walks.begin(), walks.end()};
}

}  // namespace campuswalk::tools
