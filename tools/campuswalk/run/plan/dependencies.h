#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "config/loader/overrides.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Which files the walks of a run are made from, as far as reading them tells.
class Dependencies {
public:
    explicit Dependencies(const RunSettings& settings);

    /// With such files, and those that walks are looked for in.
    const std::set<std::filesystem::path>& folders() const { return folders_; }

    /// The walks that are to be played again when files have changed; none where that may be any: when a file
    /// is gone, of an avatar that may hide another, of walks.config.yaml.
    std::vector<std::filesystem::path> walks_of(const std::set<std::filesystem::path>& changed) const;

private:
    using Paths = std::set<std::filesystem::path>;

    void add_folder(const std::filesystem::path& folder);
    void add_folders_below(const std::filesystem::path& folder);
    void add_walk(WalkLoader& loader, const std::filesystem::path& walk, const config::Overrides& overrides);
    void depends(const std::filesystem::path& walk, const std::filesystem::path& file);
    /// Of the models in the nearest folder above it that has some.
    Paths walks_of_model_at(const std::filesystem::path& file) const;

    std::filesystem::path output_;
    Paths folders_;
    std::map<std::filesystem::path, Paths> walks_by_file_;
    std::map<std::filesystem::path, Paths> walks_by_model_folder_;  ///< with their textures and buffers
    Paths with_mistakes_;                                           ///< that may be of any file
};

}  // namespace campuswalk::tools
