#include "tools/campuswalk/loading/walk_loader.h"

#include <algorithm>
#include <iterator>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_campus.h"
#include "engine/script/resolve_targets.h"
#include "engine/simulation/check_go_to.h"
#include "engine/simulation/check_walk.h"
#include "engine/simulation/route_folder.h"
#include "scene/base/installation.h"
#include "scene/cache/load_model.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/loading/campus_hash.h"
#include "tools/campuswalk/loading/model_importer.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> named_roots;

/// Of an installed program its own; of one in SOURCES/build/PRESET those of the sources. Never both: above an
/// installation others may have a folder of that name.
fs::path profiles_folder(const fs::path& installed) {
    std::error_code ignored;
    if (fs::path own = installed / "config"; fs::is_directory(own, ignored)) {
        return own;
    }
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    return program.parent_path().parent_path().parent_path() / "config";
}

std::vector<bool> images_beside(const scene::CampusDescription& description) {
    std::vector<bool> beside;
    for (const scene::SceneFile& scene : description.scenes) {
        beside.push_back(scene.images_beside);
    }
    return beside;
}

fs::path as_key(const fs::path& file) {
    std::error_code ignored;
    return fs::weakly_canonical(file, ignored);
}

}  // namespace

config::SearchPaths search_paths() {
    const fs::path installed = scene::installed_data();
    config::SearchPaths paths;
    paths.roots = named_roots;
    paths.roots.push_back(installed);
    const fs::path config = profiles_folder(installed);
    paths.avatars.push_back(config / "avatars");
    paths.lights.push_back(config / "lights");
    return paths;
}

void add_root_option(Command command) {
    command.option(
        {.names = "--root",
         .help = "Also read files below this folder, besides those of the project; may be repeated",
         .value = "DIR",
         .check =
             [](const std::string& folder) {
                 std::error_code ignored;
                 return fs::is_directory(folder, ignored) ? "" : "'" + folder + "' isn't a folder";
             }},
        named_roots);
}

WalkLoader::WalkLoader(Warn warn, config::SearchPaths search)
    : warn_(std::move(warn)), search_(search), loader_(std::move(search)) {}

LoadedWalk WalkLoader::load_walk(const fs::path& walk_file) {
    return ready(read(walk_file));
}

config::Run WalkLoader::read(const fs::path& walk_file, const config::Overrides& overrides) {
    config::Run run = loader_.load(walk_file, overrides);
    warn_(run.warnings);
    return run;
}

LoadedWalk WalkLoader::ready(config::Run run) {
    std::vector<scene::Diagnostic> warnings;
    LoadedWalk loaded;
    const BuiltCampus& built = build(run.walk.campus, *run.campus, run.walk.sim.tree, warnings);
    loaded.campus = built.campus;
    loaded.routes = built.routes;
    loaded.walk = std::move(run.walk);
    loaded.walk.origin = loaded.campus->origin;
    std::vector<scene::Diagnostic> found = engine::resolve_targets(*loaded.campus, loaded.walk);
    std::ranges::move(engine::check_walk(*loaded.campus, loaded.walk), std::back_inserter(found));
    const auto errors = std::stable_partition(found.begin(), found.end(), [](const scene::Diagnostic& each) {
        return each.severity == scene::Severity::warning;
    });
    warnings.insert(warnings.end(), found.begin(), errors);
    warn_(warnings);
    if (errors != found.end()) {
        throw scene::InputError(std::vector<scene::Diagnostic>(errors, found.end()));
    }
    return loaded;
}

std::vector<scene::Diagnostic> WalkLoader::check_go_to(const LoadedWalk& loaded) {
    return engine::check_go_to(*loaded.campus, loaded.walk, loaded.routes.get());
}

std::shared_ptr<const scene::Campus> WalkLoader::load_campus(const fs::path& campus_file) {
    std::vector<scene::Diagnostic> warnings;
    const scene::CampusDescription description = config::load_campus_description(campus_file, search_);
    std::shared_ptr<const scene::Campus> campus =
        build(campus_file, description, engine::SimSettings().tree, warnings).campus;
    warn_(warnings);
    return campus;
}

const std::set<fs::path>& WalkLoader::files_of(const fs::path& campus_file,
                                               const scene::CampusDescription& description) {
    const auto [known, is_new] =
        files_.try_emplace(SourceKey{as_key(campus_file), images_beside(description)});
    if (is_new) {
        std::set<fs::path>& files = known->second;
        files.insert(description.place_files.begin(), description.place_files.end());
        for (const scene::SceneFile& scene : description.scenes) {
            files.insert(scene.path);
            if (unreadable_->contains(scene.path)) {
                continue;
            }
            try {
                const std::vector<fs::path> read =
                    scene::files_of_model(scene, scene::EmptyModel::refuse, importer(1), model_cache());
                files.insert(read.begin(), read.end());
            } catch (const scene::InputError&) {
                continue;  // building the campus says why
            }
        }
    }
    return known->second;
}

scene::Importer WalkLoader::importer(std::size_t at_once) {
    return [unreadable = unreadable_.get(), import = model_importer(at_once)](const scene::SceneFile& file,
                                                                              scene::EmptyModel if_empty) {
        try {
            return import(file, if_empty);
        } catch (const scene::InputError&) {
            unreadable->add(file.path);
            throw;
        }
    };
}

const WalkLoader::BuiltCampus& WalkLoader::build(const fs::path& file,
                                                 const scene::CampusDescription& description,
                                                 collision::TreeKind tree,
                                                 std::vector<scene::Diagnostic>& warnings) {
    const fs::path key = as_key(file);
    if (const auto known = broken_.find(key); known != broken_.end()) {
        throw known->second;  // models take long to read, and a thousand walks may use them
    }
    const SourceKey source{key, images_beside(description)};
    BuiltCampus& built = campuses_[{source, tree}];
    if (!built.campus) {
        try {
            const std::size_t at_once = imports_at_once(description.scenes.size());
            built.campus = std::make_shared<scene::Campus>(
                scene::load_campus(description, collision::make_bullet_broad_phase(), warnings,
                                   importer(at_once), model_cache(), at_once, tree));
            files_[source] = built.campus->files;
            if (const scene::CacheFolder* cache = model_cache()) {
                if (const auto contents = hash_of_campus(*built.campus, file, *cache)) {
                    built.routes->store = std::make_shared<engine::RouteFolder>(*cache, *contents);
                }
            }
        } catch (const scene::InputError& error) {
            broken_.emplace(key, error);
            throw;
        }
    }
    return built;
}

std::vector<fs::path> files_of(const scene::Campus& campus, const fs::path& campus_file) {
    std::vector<fs::path> files(campus.files.begin(), campus.files.end());
    files.push_back(campus_file);
    return files;
}

}  // namespace campuswalk::tools
