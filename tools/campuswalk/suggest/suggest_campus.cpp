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
#include "scene/suggest/walkable_ground.h"
#include "scene/whole_file.h"
#include "tools/campuswalk/cache_choice.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/model_importer.h"
#include "tools/campuswalk/suggest/campus_text.h"
#include "tools/campuswalk/walk_loader.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using Eigen::Vector3d;
using scene::WalkableGround;

namespace {

constexpr std::size_t kMostVisits = 3;

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

/// The model the way it should stand: turned upright, and near the origin.
struct UprightModel {
    scene::SceneFile file;
    std::vector<scene::Model> models;
    scene::ModelReport report;
};

UprightModel load_upright(const scene::SceneFile& file) {
    UprightModel upright{file, {}, {}};
    for (int turn = 0; turn < 3; ++turn) {
        scene::ImportedModel imported =
            load_model(upright.file, scene::EmptyModel::refuse, model_importer(), wanted_cache()).imported;
        upright.report = scene::report(imported.model);
        upright.models.assign(1, std::move(imported.model));
        const scene::Bounds& bounds = upright.report.bounds;
        if (is_odd(upright.report, "z-up") && upright.file.up == scene::UpAxis::y) {
            upright.file.up = scene::UpAxis::z;
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

/// Where to look for ground: about the building nearest to the middle of them all.
Vector3d middle_of(const scene::ModelReport& report, const std::vector<scene::SuggestedBuilding>& buildings) {
    const Vector3d middle = 0.5 * (report.bounds.min + report.bounds.max);
    Vector3d best = middle;
    double nearest = 1e300;
    for (const scene::SuggestedBuilding& building : buildings) {
        const Vector3d centre = 0.5 * (building.bounds.min + building.bounds.max);
        if ((centre - middle).norm() < nearest) {
            nearest = (centre - middle).norm();
            best = centre;
        }
    }
    return best;
}

bool holds(const scene::Bounds& box, const Vector3d& point) {
    constexpr double kInside = 0.3;  // metres: a shoulder's breadth
    return (point.array() >= box.min.array() + kInside).all() &&
           (point.array() <= box.max.array() - kInside).all();
}

/// The spot nearest to `from` of those that can be reached and `wanted(foot)`.
template <typename Wanted>
std::optional<std::uint32_t> nearest_spot(const WalkableGround& ground,
                                          const std::vector<std::uint32_t>& ways, const Vector3d& from,
                                          const Wanted& wanted) {
    std::optional<std::uint32_t> best;
    double nearest = 1e300;
    for (std::uint32_t s = 0; s < ways.size(); ++s) {
        const Vector3d& foot = ground.spots()[s].foot;
        const double distance = (foot - from).norm();
        if (ways[s] != s && ground.spots()[s].from_edge > 0 && distance < nearest && wanted(foot)) {
            nearest = distance;
            best = s;
        }
    }
    return best;
}

/// From the spawn to the nearest buildings, from each to the next; without any, a few metres.
std::vector<SuggestedVisit> visits_from(std::uint32_t spawn, const WalkableGround& ground,
                                        std::vector<scene::SuggestedBuilding> buildings) {
    std::vector<SuggestedVisit> visits;
    std::uint32_t at = spawn;
    const auto visit = [&](const std::string& building, const std::vector<std::uint32_t>& ways,
                           std::uint32_t end) {
        std::vector<Vector3d> corners = ground.corners_of_way(ways, end);
        corners.erase(corners.begin());
        visits.push_back({building, std::move(corners)});
        at = end;
    };
    while (visits.size() < kMostVisits) {
        const std::vector<std::uint32_t> ways = ground.ways_from(at);
        const Vector3d& here = ground.spots()[at].foot;
        std::optional<std::uint32_t> nearest;
        std::size_t chosen = 0;
        for (std::size_t b = 0; b < buildings.size(); ++b) {
            const scene::Bounds box = trigger_about(buildings[b]);
            const auto spot =
                nearest_spot(ground, ways, here, [&](const Vector3d& foot) { return holds(box, foot); });
            if (spot && (!nearest || (ground.spots()[*spot].foot - here).norm() <
                                         (ground.spots()[*nearest].foot - here).norm())) {
                nearest = spot;
                chosen = b;
            }
        }
        if (!nearest) {
            break;
        }
        visit(buildings[chosen].id, ways, *nearest);
        buildings.erase(buildings.begin() + static_cast<std::ptrdiff_t>(chosen));
    }
    if (visits.empty()) {
        constexpr double kStroll = 5.0;  // metres
        const std::vector<std::uint32_t> ways = ground.ways_from(spawn);
        const Vector3d& here = ground.spots()[spawn].foot;
        const auto end = nearest_spot(ground, ways, here,
                                      [&](const Vector3d& foot) { return (foot - here).norm() >= kStroll; });
        if (end) {
            visit("", ways, *end);
        }
    }
    return visits;
}

SuggestedCampus suggestion(const UprightModel& model, const fs::path& campus_file) {
    SuggestedCampus campus;
    campus.scene = model.file;
    campus.model = fs::absolute(model.file.path)
                       .lexically_normal()
                       .lexically_relative(fs::absolute(campus_file).lexically_normal().parent_path())
                       .generic_string();
    campus.buildings = scene::suggest_buildings(model.report);
    std::vector<scene::NodeRef> roots;
    for (std::size_t n = 0; n < model.models[0].nodes.size(); ++n) {
        if (model.models[0].nodes[n].parent < 0) {
            roots.push_back({0, n});
        }
    }
    scene::BakedMesh baked = scene::bake_mesh(scene::gather_geometry(model.models, roots));
    const Vector3d middle = middle_of(model.report, campus.buildings);
    std::optional<std::uint32_t> spawn;
    if (!baked.mesh.triangles.empty()) {
        const WalkableGround ground(std::make_shared<const collision::MeshCollider>(std::move(baked.mesh)),
                                    baked.p_world_origin, middle);
        spawn = ground.best_spot(middle);
        if (spawn) {
            campus.spawn = ground.spots()[*spawn].foot;
            campus.visits = visits_from(*spawn, ground, campus.buildings);
        }
    }
    if (!spawn) {
        throw about(
            model.file.file, "no-ground",
            "nobody can stand anywhere in the middle of it; look at what `campuswalk info` says of its size "
            "and axes, and give --scale or --up");
    }
    if (!campus.visits.empty() && !campus.visits[0].corners.empty()) {
        const Vector3d ahead = campus.visits[0].corners[0] - campus.spawn;
        campus.yaw_deg = std::atan2(-ahead.x(), -ahead.z()) * 180.0 / 3.14159265358979323846;
    }
    return campus;
}

bool walks(const fs::path& walk_file) {
    WalkLoader loader([](const std::vector<scene::Diagnostic>&) {});
    const LoadedWalk loaded = loader.load_walk(walk_file);
    return engine::run_walk(*loaded.campus, loaded.walk, {}).passed;
}

}  // namespace

int suggest_campus(const scene::SceneFile& model, const fs::path& campus_file, bool overwrite) {
    const fs::path walk_file = walk_beside(campus_file, overwrite);
    const SuggestedCampus campus = suggestion(load_upright(model), campus_file);
    scene::write_whole_file(campus_file, campus_yaml(campus));
    // What was planned on a grid is only written down if it can be walked.
    std::size_t visits = campus.visits.size();
    bool passed = false;
    for (;; --visits) {
        scene::write_whole_file(walk_file, walk_yaml(campus, campus_file.filename().string(), visits));
        passed = walks(walk_file);
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
    return kPass;
}

}  // namespace campuswalk::tools
