#include "tools/campuswalk_bench/pairs/pair_case.h"

#include <cstdio>

#include "tools/campuswalk_bench/pairs/pair_engines.h"
#include "tools/campuswalk_bench/pairs/pair_runs.h"

namespace campuswalk::tools::bench {

namespace {

// The first is the reference: it shares no kernel with the others.
constexpr const char* kEngines[] = {"paper",          "wide_sse42", "wide_avx2", "wide_avx512", "fcl_obb",
                                    "bullet_gimpact", "ode",        "embree",    "cgal"};

void print_query(const Results& results, std::size_t placement, const EngineName& engine, Query query) {
    const Measurement* m = results.find(placement, engine.name, query);
    if (m == nullptr) {
        std::printf("%14s%14s  %-10s", "-", "-", "");
    } else {
        std::printf("%14.1f%14.1f  %-10s", m->us_min, m->us_median,
                    m->difference.none() ? "" : to_string(m->difference).c_str());
    }
}

void print_placement(const Results& results, std::size_t placement) {
    std::printf("%zu pairs\n", results.pairs[placement]);
    std::printf("%16s%14s%14s  %-10s%14s%14s\n", "", "all: least", "median", "", "first: least", "median");
    for (const EngineName& engine : results.engines) {
        std::printf("%16s", engine.name.c_str());
        print_query(results, placement, engine, Query::all);
        print_query(results, placement, engine, Query::first);
        std::printf("\n");
    }
}

}  // namespace

CaseResult run_pair_case(const PairScene& scene, int rounds) {
    const PairEngines made = make_engines(scene.a, scene.b, kEngines);
    const Results results = measure(scene, made.engines, rounds);
    std::printf(
        "%zu triangles against %zu. Microseconds per query of %d, one thread; +n/-n: extra and missing\n"
        "pairs, compared with %s.\n",
        scene.a.triangles.size(), scene.b.triangles.size(), rounds, results.engines.front().name.c_str());
    for (std::size_t placement = 0; placement < scene.placements.size(); ++placement) {
        print_placement(results, placement);
    }
    for (const std::string& absent : made.absent) {
        std::printf("  absent: %s\n", absent.c_str());
    }
    return {rows_of(results), !report_our_errors(scene, results)};
}

}  // namespace campuswalk::tools::bench
