#include "tools/campuswalk/suggest/suggest_campus.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "collision/mesh_collider.h"
#include "engine/run_walk.h"
#include "scene/bake_mesh.h"
#include "scene/cache/load_model.h"
#include "scene/model_report.h"
#include "scene/node_selection.h"
#include "scene/oddities/named_sizes.h"
#include "scene/oddities/wording.h"
#include "scene/suggest/first_view.h"
#include "scene/suggest/walkable_ground.h"
#include "scene/whole_file.h"
#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/model_importer.h"
#include "tools/campuswalk/oddities_text.h"
#include "tools/campuswalk/suggest/campus_text.h"
#include "tools/campuswalk/suggest/plan_visits.h"
#include "tools/campuswalk/walk_loader.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using Eigen::Vector3d;

namespace {

constexpr std::size_t kLeastGround = 16;  // spots of a quarter of a square metre

scene::InputError about(const fs::path& file, const char* code, const std::string& message) {
    return scene::InputError(scene::SourceMark{file.string(), 0, 0}, code, message);
}

/// Throws if they may not be written.
fs::path walk_beside(const fs::path& campus_file, bool overwrite) {
    const std::string name = campus_file.filename().string();
    const std::string ending = ".campus.yaml";
    if (!name.ends_with(ending) || name.size() == ending.size()) {
        throw about(campus_file, "file-name", "a campus file is called NAME.campus.yaml");
    }
    fs::path walk = campus_file;
    walk.replace_filename(name.substr(0, name.size() - ending.size()) + ".walk.yaml");
    for (const fs::path& file : {campus_file, walk}) {
        if (!overwrite && fs::exists(file)) {
            throw about(file, "file-exists", "it is there already; name another, or say --overwrite");
        }
    }
    return walk;
}

bool is_odd(const scene::ModelReport& report, const std::string& code) {
    return std::ranges::any_of(report.warnings, [&](const scene::Oddity& odd) { return odd.code == code; });
}

/// The model the way it should stand: turned upright, with doors as high as doors, and near the origin.
struct UprightModel {
    scene::SceneFile file;
    std::vector<scene::Model> models;
    scene::ModelReport report;
};

UprightModel load_upright(const scene::SceneFile& file) {
    UprightModel upright{file, {}, {}};
    for (int turn = 0; turn < 4; ++turn) {
        scene::ImportedModel imported =
            load_model(upright.file, scene::EmptyModel::refuse, model_importer(), wanted_cache()).imported;
        upright.report = scene::report(imported.model);
        upright.models.assign(1, std::move(imported.model));
        const scene::Bounds& bounds = upright.report.bounds;
        if (is_odd(upright.report, "z-up") && upright.file.up == scene::UpAxis::y) {
            upright.file.up = scene::UpAxis::z;
        } else if (const auto scale = scene::scale_by_doors(upright.models[0], upright.report.nodes)) {
            upright.file.scale *= *scale;
        } else if (is_odd(upright.report, "far-from-origin") && upright.file.position.isZero(0.0)) {
            Vector3d middle = 0.5 * (bounds.min + bounds.max);
            middle.y() = bounds.min.y();
            upright.file.position = -middle.array().round();
        } else {
            break;
        }
    }
    return upright;
}

const scene::SuggestedBuilding* nearest_building(const std::vector<scene::SuggestedBuilding>& buildings,
                                                 const Vector3d& place) {
    const auto nearest = std::ranges::min_element(
        buildings, {}, [&](const scene::SuggestedBuilding& b) { return (b.box.center - place).norm(); });
    return nearest == buildings.end() ? nullptr : &*nearest;
}

/// A box below the whole model and what is around it. On a slope that isn't there, its top is where the
/// middle one of the buildings begins.
scene::Bounds stand_in_ground(const scene::Bounds& model,
                              const std::vector<scene::SuggestedBuilding>& buildings) {
    constexpr double kAround = 20.0;  // metres
    constexpr double kThick = 0.5;    // metres
    std::vector<double> bottoms;
    for (const scene::SuggestedBuilding& building : buildings) {
        bottoms.push_back(building.box.center.y() - 0.5 * building.box.size.y());
    }
    std::sort(bottoms.begin(), bottoms.end());
    const Vector3d around(kAround, 0.0, kAround);
    scene::Bounds ground{model.min - around, model.max + around};
    ground.max.y() = bottoms.empty() ? model.min.y() : bottoms[bottoms.size() / 2];
    ground.min.y() = ground.max.y() - kThick;
    return ground;
}

void add_top(const scene::Bounds& box, scene::WorldGeometry& geometry) {
    const auto first = static_cast<std::uint32_t>(geometry.positions.size());
    const double y = box.max.y();
    geometry.positions.insert(geometry.positions.end(),
                              {Vector3d(box.min.x(), y, box.min.z()), Vector3d(box.min.x(), y, box.max.z()),
                               Vector3d(box.max.x(), y, box.max.z()), Vector3d(box.max.x(), y, box.min.z())});
    geometry.triangles.push_back({first, first + 1, first + 2});
    geometry.triangles.push_back({first, first + 2, first + 3});
}

struct Solid {
    std::shared_ptr<const collision::MeshCollider> mesh;  ///< null for a model without a triangle
    Vector3d p_world_origin;
};

Solid solid_of(const UprightModel& model, const std::optional<scene::Bounds>& ground) {
    std::vector<scene::NodeRef> roots;
    for (std::size_t n = 0; n < model.models[0].nodes.size(); ++n) {
        if (model.models[0].nodes[n].parent < 0) {
            roots.push_back({0, n});
        }
    }
    scene::WorldGeometry geometry = scene::gather_geometry(model.models, roots);
    if (ground) {
        add_top(*ground, geometry);
    }
    scene::BakedMesh baked = scene::bake_mesh(geometry);
    return baked.mesh.triangles.empty()
               ? Solid{nullptr, baked.p_world_origin}
               : Solid{std::make_shared<const collision::MeshCollider>(std::move(baked.mesh)),
                       baked.p_world_origin};
}

/// Finds a spawn, what to see from it and where to walk to. False if there is no ground, or next to none.
bool place_visitor(const UprightModel& model, SuggestedCampus& campus) {
    const Solid solid = solid_of(model, campus.ground);
    if (!solid.mesh) {
        return false;
    }
    Vector3d middle = 0.5 * (model.report.bounds.min + model.report.bounds.max);
    if (const auto* building = nearest_building(campus.buildings, middle)) {
        middle = building->box.center;
    }
    std::vector<scene::UprightBox> triggers;
    for (const scene::SuggestedBuilding& building : campus.buildings) {
        triggers.push_back(trigger_about(building));
    }
    const scene::WalkableGround ground(solid.mesh, solid.p_world_origin, middle);
    const std::optional<std::uint32_t> spawn = ground.best_spot(middle, triggers);
    if (!spawn || ground.count_reachable(*spawn) < kLeastGround) {
        return false;
    }
    campus.spawn = ground.spots()[*spawn].foot;
    campus.visits = plan_visits(*spawn, ground, campus.buildings);
    const auto* target = nearest_building(campus.buildings, campus.spawn);
    const double yaw = scene::first_view(*solid.mesh, solid.p_world_origin, campus.spawn,
                                         target == nullptr ? middle : target->box.center);
    campus.yaw_deg = yaw * 180.0 / 3.14159265358979323846;
    return true;
}

SuggestedCampus suggestion(const UprightModel& model, const fs::path& campus_file) {
    SuggestedCampus campus;
    campus.scene = model.file;
    campus.model = fs::absolute(model.file.path)
                       .lexically_normal()
                       .lexically_relative(fs::absolute(campus_file).lexically_normal().parent_path())
                       .generic_string();
    campus.buildings = scene::suggest_buildings(model.models[0], model.report);
    const double size = (model.report.bounds.max - model.report.bounds.min).maxCoeff();
    const bool tiny = is_odd(model.report, "odd-scale") && size < 1.0;
    bool placed = !tiny && !is_odd(model.report, "no-ground") && place_visitor(model, campus);
    if (!placed && !tiny) {
        campus.ground = stand_in_ground(model.report.bounds, campus.buildings);
        placed = place_visitor(model, campus);
    }
    if (!placed) {
        throw about(
            model.file.file, "no-ground",
            "nobody can stand anywhere in the middle of it; look at what `campuswalk info` says of its size "
            "and axes, and give --scale or --up");
    }
    return campus;
}

bool walks(WalkLoader& loader, const fs::path& walk_file) {
    const LoadedWalk loaded = loader.load_walk(walk_file);
    return engine::run_walk(*loaded.campus, loaded.walk, {}).passed;
}

}  // namespace

int suggest_campus(const scene::SceneFile& model, const fs::path& campus_file, bool overwrite) {
    const fs::path walk_file = walk_beside(campus_file, overwrite);
    const UprightModel upright = load_upright(model);
    const SuggestedCampus campus = suggestion(upright, campus_file);
    scene::write_whole_file(campus_file, campus_yaml(campus));
    // What was planned on a grid is only written down if it can be walked.
    WalkLoader loader([](const std::vector<scene::Diagnostic>&) {});
    std::size_t visits = campus.visits.size();
    bool passed = false;
    for (;; --visits) {
        scene::write_whole_file(walk_file, walk_yaml(campus, campus_file.filename().string(), visits));
        try {
            passed = walks(loader, walk_file);
        } catch (const scene::InputError&) {
            fs::remove(campus_file);
            fs::remove(walk_file);
            throw;
        }
        if (passed || visits == 0) {
            break;
        }
    }
    if (!passed) {
        fs::remove(campus_file);
        fs::remove(walk_file);
        throw about(model.file, "no-ground", "no place was found where a visitor stays standing");
    }
    std::printf("%s: %zu buildings\n%s: %zu ways, walked\n", campus_file.string().c_str(),
                campus.buildings.size(), walk_file.string().c_str(), visits);
    std::printf("%s about the model as it stands there\n",
                scene::plural(upright.report.warnings.size(), "warning").c_str());
    print_oddities(upright.report.warnings);
    return kPass;
}

}  // namespace campuswalk::tools
