#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "config/loader/load_run.h"
#include "engine/script/walk.h"
#include "engine/simulation/route_memory.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

/// Where the program's own profiles are, in the source tree that it was built in or where it is installed,
/// and what files may be read besides those of a project: the installed examples, and what `--root` names.
config::SearchPaths search_paths();

/// A walk that is ready to run: read and checked, with its campus.
struct LoadedWalk {
    engine::Walk walk;
    std::shared_ptr<const scene::Campus> campus;
    std::shared_ptr<engine::RouteMemory> routes;  ///< of the campus; for one thread
};

/// Models whose import failed, which may take as long as an import may. Several threads may add some.
class UnreadableModels {
public:
    void add(const std::filesystem::path& model) {
        const std::lock_guard lock(mutex_);
        models_.insert(model);
    }
    bool contains(const std::filesystem::path& model) const {
        const std::lock_guard lock(mutex_);
        return models_.contains(model);
    }

private:
    mutable std::mutex mutex_;
    std::set<std::filesystem::path> models_;
};

/// Reads walks; those on the same campus with the same kind of trees share it. Warnings are reported at once;
/// errors are thrown as scene::InputError, all of a file together.
class WalkLoader {
public:
    using Warn = std::function<void(const std::vector<scene::Diagnostic>&)>;
    explicit WalkLoader(Warn warn = diagnose, config::SearchPaths search = search_paths());

    /// The same as `read`, then `ready`.
    LoadedWalk load_walk(const std::filesystem::path& walk_file);

    /// Reads only the YAML; the campus's models aren't read.
    config::Run read(const std::filesystem::path& walk_file, const config::Overrides& overrides = {});
    /// Checks what a project names, without a walk; see config::RunLoader::check.
    void check(const config::Overrides& overrides) { loader_.check(overrides); }
    /// Builds the campus unless that was done before, and checks the walk against it.
    LoadedWalk ready(config::Run run);

    /// A warning for each place that the walk's steps can't get to. Takes as long as playing them.
    static std::vector<scene::Diagnostic> check_go_to(const LoadedWalk& loaded);

    std::shared_ptr<const scene::Campus> load_campus(const std::filesystem::path& campus_file);

    /// What the campus is read from besides its YAML file: models, buffers, textures and files of places, as
    /// far as the models can be read. A campus that wasn't built isn't built for that.
    const std::set<std::filesystem::path>& files_of(const std::filesystem::path& campus_file,
                                                    const scene::CampusDescription& description);

private:
    struct BuiltCampus {
        std::shared_ptr<const scene::Campus> campus;
        std::shared_ptr<engine::RouteMemory> routes = std::make_shared<engine::RouteMemory>();
    };

    /// Notes which models it can't import.
    scene::Importer importer(std::size_t at_once);
    const BuiltCampus& build(const std::filesystem::path& file, const scene::CampusDescription& description,
                             collision::TreeKind tree, std::vector<scene::Diagnostic>& warnings);

    Warn warn_;
    config::SearchPaths search_;
    config::RunLoader loader_;
    /// The campus' file, and of each scene whether images may come from beside its folder: that depends on
    /// the project.
    using SourceKey = std::pair<std::filesystem::path, std::vector<bool>>;
    std::map<SourceKey, std::set<std::filesystem::path>> files_;
    std::map<std::pair<SourceKey, collision::TreeKind>, BuiltCampus> campuses_;
    std::map<std::filesystem::path, scene::InputError> broken_;  ///< why campuses can't be built
    std::unique_ptr<UnreadableModels> unreadable_ = std::make_unique<UnreadableModels>();
};

/// Every file that the campus is read from, its YAML file included.
std::vector<std::filesystem::path> files_of(const scene::Campus& campus,
                                            const std::filesystem::path& campus_file);

/// `--root`, for commands that read walks or campuses.
void add_root_option(Command command);

}  // namespace campuswalk::tools
