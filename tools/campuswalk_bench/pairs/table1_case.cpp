#include "tools/campuswalk_bench/pairs/table1_case.h"

#include <cstdio>
#include <vector>

#include "tools/campuswalk_bench/pairs/figure4.h"
#include "tools/campuswalk_bench/pairs/pair_engines.h"
#include "tools/campuswalk_bench/pairs/pair_runs.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"
#include "tools/campuswalk_bench/pairs/print_table1.h"

namespace campuswalk::tools::bench {

namespace {

constexpr const char* kHybridEngines[] = {"paper", "obb", "sphere"};
constexpr const char* kMixed = "mixed";
constexpr const char* kBvh8AndPeers[] = {"wide_sse42",     "wide_avx2", "wide_avx512", "fcl_obb",
                                         "bullet_gimpact", "ode",       "embree",      "cgal"};

}  // namespace

CaseResult run_table1(int rounds, bool mixed, const std::filesystem::path& plot) {
    std::vector<const char*> names(std::begin(kHybridEngines), std::end(kHybridEngines));
    if (mixed) {
        names.push_back(kMixed);
    }
    names.insert(names.end(), std::begin(kBvh8AndPeers), std::end(kBvh8AndPeers));

    const PairScene scene = table1_pair_scene();
    const PairEngines made = make_engines(scene.a, scene.b, names);
    const Results results = measure(scene, made.engines, rounds);
    std::printf("A teapot of %zu triangles intersects a cylinder of %zu.\n", scene.b.triangles.size(),
                scene.a.triangles.size());
    print_table1(results);
    for (const std::string& absent : made.absent) {
        std::printf("  absent: %s\n", absent.c_str());
    }
    if (!plot.empty()) {
        plot_figure4(results, plot);
    }
    return {rows_of(results), !report_our_errors(scene, results)};
}

}  // namespace campuswalk::tools::bench
