#include "tools/campuswalk_bench/trees/tree_cases.h"

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"
#include "tools/campuswalk_bench/trees/our_builders.h"

namespace campuswalk::tools::bench {

using collision::MeshCollider;
using collision::TreeKind;
using collision::TriangleMesh;

namespace {

/// The builders of one library, one per mesh.
struct Builders {
    std::string name;
    std::array<std::unique_ptr<TreeBuilder>, 2> of;

    void build() const {
        for (const auto& builder : of) {
            builder->build();
        }
    }
    void discard() const {
        for (const auto& builder : of) {
            builder->discard();
        }
    }
};

std::vector<Builders> make_builders(const PairScene& scene) {
    std::vector<Builders> made;
    const auto add = [&](const char* name, const auto& make) {
        made.push_back({name, {make(scene.a), make(scene.b)}});
    };
    add("wide", [](const TriangleMesh& mesh) { return make_our_builder(mesh, TreeKind::bvh8); });
    add("paper", [](const TriangleMesh& mesh) { return make_our_builder(mesh, TreeKind::hybrid); });
    unless_absent("fcl_obb", [&] {
        add("fcl_obb", [](const TriangleMesh& mesh) {
            return make_peer<MakeTreeBuilder>("fcl_obb", kMakeTreeBuilder, mesh);
        });
    });
    return made;
}

void time_builds(const std::vector<Builders>& builders, double triangles, int rounds,
                 std::vector<Row>& rows) {
    const auto spreads = shuffled_runs(builders.size(), rounds, [&](std::size_t i) {
        const double microseconds = microseconds_of([&] { builders[i].build(); });
        builders[i].discard();
        return microseconds;
    });
    std::printf("Building, microseconds per triangle\n%12s%10s%10s\n", "", "least", "median");
    for (std::size_t i = 0; i < builders.size(); ++i) {
        const Spread each{spreads[i].least / triangles, spreads[i].median / triangles};
        std::printf("%12s%10.3f%10.3f\n", builders[i].name.c_str(), each.least, each.median);
        rows.push_back({"build", {}, builders[i].name, "build", each.least, each.median, {}, {}});
    }
}

void print_bytes(const Row& row, const char* what) {
    std::printf("%12s%10.1f  %s\n", row.engine.c_str(), row.least, what);
}

void measure_heap(const std::vector<Builders>& builders, double triangles, std::vector<Row>& rows) {
    for (const Builders& of_one : builders) {
        const std::size_t before = heap_in_use();
        of_one.build();
        const std::size_t after = heap_in_use();
        of_one.discard();
        if (after <= before) {
            std::printf("  absent: heap_bytes: this build doesn't count its heap\n");
            return;
        }
        const double bytes = static_cast<double>(after - before) / triangles;
        rows.push_back({"memory", {}, of_one.name, "heap_bytes", bytes, bytes, {}, {}});
        print_bytes(rows.back(), "mesh and tree, as allocated");
    }
}

void measure_data(const PairScene& scene, double triangles, std::vector<Row>& rows) {
    for (const auto& [name, tree_kind] :
         {std::pair("wide", TreeKind::bvh8), std::pair("paper", TreeKind::hybrid)}) {
        double meshes = 0.0;
        double trees = 0.0;
        for (const TriangleMesh* mesh : {&scene.a, &scene.b}) {
            const MeshCollider collider(*mesh, tree_kind, collision::Interior::unknown);
            meshes += static_cast<double>(bytes_of_mesh(collider.mesh()));
            trees += static_cast<double>(bytes_of_tree(collider));
        }
        const double both = (meshes + trees) / triangles;
        rows.push_back({"memory", {}, name, "data_bytes", both, both, {}, {}});
        print_bytes(rows.back(), "mesh and tree, by their sizes");
        rows.push_back({"memory", {}, name, "tree_bytes", trees / triangles, trees / triangles, {}, {}});
        print_bytes(rows.back(), "the tree alone, by its size");
    }
}

}  // namespace

CaseResult run_tree_cases(int rounds) {
    const PairScene scene = table1_pair_scene();
    const auto triangles = static_cast<double>(scene.a.triangles.size() + scene.b.triangles.size());
    std::printf("Trees of Table I's two meshes, %.0f triangles; times of %d.\n", triangles, rounds);
    const std::vector<Builders> builders = make_builders(scene);
    CaseResult result;
    time_builds(builders, triangles, rounds, result.rows);
    std::printf("Memory, bytes per triangle\n");
    measure_heap(builders, triangles, result.rows);
    measure_data(scene, triangles, result.rows);
    return result;
}

}  // namespace campuswalk::tools::bench
