#include "tools/campuswalk_bench/import/import_cases.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "scene/base/atomic_file.h"
#include "scene/campus/campus_description.h"
#include "scene/export/named_glb.h"
#include "scene/model/model.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/files/scratch_folder.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

namespace {

scene::Model one_mesh(const collision::TriangleMesh& triangles) {
    scene::Model model;
    scene::Mesh mesh;
    mesh.name = "campus";
    mesh.positions = triangles.positions;
    mesh.triangles = triangles.triangles;
    model.meshes.push_back(std::move(mesh));
    model.materials.emplace_back();
    scene::Node node;
    node.name = "campus";
    node.meshes.push_back(scene::MeshIndex{0});
    model.nodes.push_back(std::move(node));
    return model;
}

/// The unit normal of each position: the mean of its triangles' normals, weighted by area.
std::vector<Eigen::Vector3f> smooth_normals(const collision::TriangleMesh& mesh) {
    std::vector<Eigen::Vector3f> normals(mesh.positions.size(), Eigen::Vector3f::Zero());
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3f& a = mesh.positions[t[0]];
        const Eigen::Vector3f n = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
        for (const std::uint32_t v : t) {
            normals[v] += n;
        }
    }
    for (Eigen::Vector3f& n : normals) {
        n = n.squaredNorm() > 0.0F ? n.normalized() : Eigen::Vector3f(0, 1, 0);
    }
    return normals;
}

/// An importer that returns the number of triangles it read.
struct Reader {
    std::string name;
    std::function<std::size_t()> read;
};

std::size_t import_by_helper(const fs::path& path) {
    scene::SceneFile file;
    file.mark.file = path.string();
    file.file = path.filename().string();
    file.path = path;
    return scene::count_triangles(model_importer()(file, scene::EmptyModel::refuse).model);
}

/// What assimp does besides reading: nothing, or missing normals and joined vertices.
enum class Steps { none, join, both };

std::vector<Reader> readers_of(const fs::path& file, Steps steps) {
    std::vector<Reader> readers = {{"helper", [=] { return import_by_helper(file); }}};
    unless_absent("assimp", [&] {
        const auto peer = reinterpret_cast<ImportWithPeer>(find_in_peer("assimp", kImportWithPeer));
        if (steps != Steps::join) {
            readers.push_back({"assimp", [=] { return std::size_t{peer(file.c_str(), false)}; }});
        }
        if (steps != Steps::none) {
            readers.push_back({steps == Steps::join ? "assimp" : "assimp-joined",
                               [=] { return std::size_t{peer(file.c_str(), true)}; }});
        }
    });
    return readers;
}

void time_readers(const std::string& query, const fs::path& file, Steps steps, std::size_t triangles,
                  int rounds, CaseResult& result) {
    const std::vector<Reader> readers = readers_of(file, steps);
    std::vector<bool> reported(readers.size(), false);
    const auto spreads = shuffled_runs(readers.size(), rounds, [&](std::size_t i) {
        std::size_t found = 0;
        const double microseconds = microseconds_of([&] { found = readers[i].read(); });
        if (found != triangles && !reported[i]) {
            reported[i] = true;
            std::printf("  %s reads %zu triangles instead of %zu\n", readers[i].name.c_str(), found,
                        triangles);
            result.ours_right = result.ours_right && i != 0;
        }
        return microseconds;
    });
    std::printf("%s, milliseconds\n%14s%10s%10s\n", query.c_str(), "", "least", "median");
    for (std::size_t i = 0; i < readers.size(); ++i) {
        std::printf("%14s%10.1f%10.1f\n", readers[i].name.c_str(), spreads[i].least / 1000.0,
                    spreads[i].median / 1000.0);
        const auto count = static_cast<double>(triangles);
        result.rows.push_back({"import",
                               {},
                               readers[i].name,
                               query,
                               spreads[i].least / count,
                               spreads[i].median / count,
                               {},
                               {}});
    }
}

}  // namespace

CaseResult run_import_cases(int lots, int rounds, const std::vector<fs::path>& models) {
    std::vector<std::size_t> found;  // before minutes of measuring: these may throw
    found.reserve(models.size());
    for (const fs::path& file : models) {
        found.push_back(import_by_helper(file));
    }
    const ScratchFolder folder;
    const collision::TriangleMesh mesh = walkable_campus(lots).mesh;
    const std::size_t triangles = mesh.triangles.size();
    std::printf("GLB files of %zu triangles, into a model of ours and into assimp's scene; times of %d.\n",
                triangles, rounds);
    const fs::path with = folder.path() / "with-normals.glb";
    const fs::path without = folder.path() / "without-normals.glb";
    scene::Model model = one_mesh(mesh);
    scene::write_file_atomically(without, scene::write_named_glb(model));
    model.meshes[0].normals = smooth_normals(mesh);
    scene::write_file_atomically(with, scene::write_named_glb(model));
    CaseResult result;
    time_readers("glb", with, Steps::none, triangles, rounds, result);
    time_readers("glb_without_normals", without, Steps::join, triangles, rounds, result);
    for (std::size_t i = 0; i < models.size(); ++i) {
        const fs::path& file = models[i];
        std::printf("%s: %zu triangles\n", file.string().c_str(), found[i]);
        time_readers(file.filename().string(), file, Steps::both, found[i], rounds, result);
    }
    return result;
}

}  // namespace campuswalk::tools::bench
