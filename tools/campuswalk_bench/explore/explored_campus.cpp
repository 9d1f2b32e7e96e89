#include "tools/campuswalk_bench/explore/explored_campus.h"

#include <stdexcept>
#include <utility>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/bullet_broad_phase.h"
#include "engine/script/avatar_body.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;
using collision::Vec3;

namespace {

/// Metres: the recast models' stairs and the garage's kerbs are made for it.
constexpr double kHighStep = 0.4;

/// A model of others, all of which is solid.
struct SharedModel {
    const char* name;
    const char* file;  ///< below the folder of the data
    Vec3 spawn;
    double step_height;
};

const SharedModel kModels[] = {
    {"dungeon", "recast/dungeon.obj", {40, 10.1, 0}, kHighStep},
    {"nav_test", "recast/nav_test.obj", {5, -2.3, 5.4}, kHighStep},
    {"parking_garage", "gazebo/parking_garage/meshes/parking_garage.dae", {20, 0.3, 0}, kHighStep},
    {"willowgarage", "gazebo/willowgarage/meshes/willowgarage_visual.dae", {19.5, 0.1, -17.6}, kHighStep},
    {"outdoor_campus", "ufaz/after153/outdoor_campus.obj", {6, 0.1, 150}, 0.3},
};

ExploredCampus load_demo() {
    ExploredCampus demo{"demo", WalkLoader().load_campus(demo_file("demo.campus.yaml")), {}, {}};
    demo.spawn = demo.campus->description.spawns.at(0).position;
    return demo;
}

ExploredCampus load_shared(const SharedModel& model, const fs::path& data) {
    const fs::path file = data / model.file;
    if (data.empty() || !fs::exists(file)) {
        throw std::runtime_error("no model at " + (data.empty() ? "--data" : data.string()) + "/" +
                                 model.file);
    }
    scene::CampusDescription description;
    description.name = model.name;
    scene::SceneFile& scene = description.scenes.emplace_back();
    scene.file = file.string();
    scene.path = file;
    scene::ColliderDescription& all = description.colliders.emplace_back();
    all.id = model.name;
    all.nodes.emplace_back().pattern = "*";
    all.modes.solid = true;
    std::vector<scene::Diagnostic> warnings;
    ExploredCampus campus{model.name, nullptr, model.spawn, {}};
    campus.campus = std::make_shared<scene::Campus>(
        scene::load_campus(std::move(description), collision::make_bullet_broad_phase(), warnings,
                           model_importer(), model_cache()));
    campus.avatar.step_height = model.step_height;
    return campus;
}

ExploredCampus make_small() {
    WalkableCampus made = walkable_campus(1);
    auto campus = std::make_shared<scene::Campus>(
        scene::Campus{{}, {}, {}, collision::World(collision::make_bullet_broad_phase())});
    collision::Object ground;
    ground.shape = std::make_shared<const collision::MeshCollider>(std::move(made.mesh));
    campus->world.add(std::move(ground));
    campus->objects.emplace_back().id = "ground";
    return {"small", std::move(campus), made.paths.front().start, {}};
}

}  // namespace

fs::path demo_file(const fs::path& name) {
    for (const fs::path& avatars : search_paths().avatars) {
        std::error_code ignored;
        if (auto file = avatars.parent_path() / name; fs::exists(file, ignored)) {
            return file;
        }
    }
    return "config" / name;
}

engine::ExploreSettings ExploredCampus::settings() const {
    engine::ExploreSettings settings;
    settings.strides.body = engine::mover_settings(avatar);
    settings.strides.walk_speed = avatar.speed;
    settings.strides.run_speed = engine::running_speed(avatar);
    settings.solids.ignored_layers = engine::ignored_layers(*campus, avatar);
    settings.starts = {spawn};
    settings.run = run;
    settings.jump = jump;
    return settings;
}

engine::WorkerWorlds ExploredCampus::worlds(std::size_t workers) const {
    return {world(), workers, collision::make_bullet_broad_phase};
}

std::vector<engine::WalkNodeId> nodes_of(const engine::WalkSpace& space) {
    std::vector<engine::WalkNodeId> nodes;
    for (std::uint32_t tile = 0; tile < space.tiles.size(); ++tile) {
        for (std::size_t i = 0; i < space.tiles[tile].nodes.size(); ++i) {
            nodes.push_back({tile, static_cast<std::uint16_t>(i)});
        }
    }
    return nodes;
}

std::vector<ExploredCampusSource> explored_campuses(const fs::path& data) {
    std::vector<ExploredCampusSource> all{{"demo", load_demo}};
    for (const SharedModel& model : kModels) {
        all.push_back({model.name, [&model, data] { return load_shared(model, data); }});
    }
    return all;
}

ExploredCampusSource small_explored_campus() {
    return {"small", make_small};
}

}  // namespace campuswalk::tools::bench
