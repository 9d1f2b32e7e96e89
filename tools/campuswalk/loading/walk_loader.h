#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "config/loader/load_run.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

/// A walk that may be run: read, checked, its campus built.
struct LoadedWalk {
    engine::Walk walk;
    std::shared_ptr<const scene::Campus> campus;
};

/// Reads walks; those on one campus, with one kind of trees, share it. Warnings are told as they come;
/// mistakes are thrown as scene::InputError, all of a file together.
class WalkLoader {
public:
    using Told = std::function<void(const std::vector<scene::Diagnostic>&)>;
    explicit WalkLoader(Told warn = diagnose);

    /// The same as `read`, then `ready`.
    LoadedWalk load_walk(const std::filesystem::path& walk_file);

    /// What is written; the campus' models aren't looked at.
    config::SharedRun read(const std::filesystem::path& walk_file, const config::Overrides& overrides = {});
    /// What a project names, without a walk; see config::RunLoader::check.
    void check(const config::Overrides& overrides) { loader_.check(overrides); }
    /// Builds the campus if it isn't yet, and checks the walk against it.
    LoadedWalk ready(config::SharedRun run);

    std::shared_ptr<const scene::Campus> load_campus(const std::filesystem::path& campus_file);

private:
    std::shared_ptr<const scene::Campus> build(const std::filesystem::path& file,
                                               const scene::CampusDescription& description,
                                               collision::TreeKind tree,
                                               std::vector<scene::Diagnostic>& warnings);

    Told warn_;
    config::RunLoader loader_;
    std::map<std::pair<std::filesystem::path, collision::TreeKind>, std::shared_ptr<const scene::Campus>>
        campuses_;
    std::map<std::filesystem::path, scene::InputError> broken_;  ///< what was wrong with campuses
};

/// Where the program's own files are: beside the source tree it was built in, or installed.
config::SearchPaths search_paths();

}  // namespace campuswalk::tools
