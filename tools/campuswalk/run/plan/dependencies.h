#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "config/loader/overrides.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Which files the walks of a run depend on, as far as reading the walks shows.
class Dependencies {
public:
    explicit Dependencies(const RunSettings& settings);

    /// The folders of these files, and those that are searched for walks.
    const std::set<std::filesystem::path>& folders() const { return folders_; }

    /// The walks to play again when files have changed; none if it may be any walk: after a file was removed,
    /// or if an avatar that may hide another one or walks.config.yaml has changed.
    std::vector<std::filesystem::path> walks_of(const std::set<std::filesystem::path>& changed) const;

private:
    using Paths = std::set<std::filesystem::path>;

    void add_folder(const std::filesystem::path& folder);
    void add_folders_below(const std::filesystem::path& folder);
    void add_walk(WalkLoader& loader, const std::filesystem::path& walk, const config::Overrides& overrides);
    void add_dependency(const std::filesystem::path& walk, const std::filesystem::path& file);
    /// The walks that use the models in the nearest folder above the file that contains models.
    Paths walks_of_model_at(const std::filesystem::path& file) const;

    std::filesystem::path output_;
    Paths folders_;
    std::map<std::filesystem::path, Paths> walks_by_file_;
    std::map<std::filesystem::path, Paths> walks_by_model_folder_;  ///< also for textures and buffers
    Paths walks_with_errors_;                                       ///< which may depend on any file
};

}  // namespace campuswalk::tools
