#include "tools/campuswalk_bench/pairs/table1_case.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tools/campuswalk_bench/measure/measurement.h"
#include "tools/campuswalk_bench/pairs/cost_model.h"
#include "tools/campuswalk_bench/pairs/figure4.h"
#include "tools/campuswalk_bench/pairs/pair_engines.h"
#include "tools/campuswalk_bench/pairs/pair_runs.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"

namespace campuswalk::tools::bench {

using collision::HybridContactStatistics;
using collision::QueryStatistics;

namespace {

/// The time of `slow` over that of `fast`, by placement.
std::vector<double> multiples(const Results& results, const char* slow, const char* fast, Query query) {
    std::vector<double> ratios = results.least_times(slow, query);
    const std::vector<double> times = results.least_times(fast, query);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        ratios[i] /= times[i];
    }
    return ratios;
}

int width_of(const EngineName& engine) {
    return std::max(9, static_cast<int>(engine.name.size()) + 2);
}

void print_times(const Results& results, Query query) {
    const std::vector<double> lift = multiples(results, "obb", "paper", query);
    std::printf("%7s", "pairs");
    for (const EngineName& engine : results.engines) {
        if (results.find(0, engine.name, query) != nullptr) {
            std::printf("%*s", width_of(engine), engine.name.c_str());
        }
    }
    std::printf("%11s\n", "obb/paper");
    for (std::size_t i = 0; i < results.pairs.size(); ++i) {
        std::printf("%7zu", results.pairs[i]);
        for (const EngineName& engine : results.engines) {
            if (const Measurement* m = results.find(i, engine.name, query)) {
                std::printf("%*.1f", width_of(engine), m->us_min);
            }
        }
        std::printf("%11.2f\n", lift[i]);
    }
    std::printf("%7s", "mean");
    for (const EngineName& engine : results.engines) {
        const std::vector<double> times = results.least_times(engine.name, query);
        if (!times.empty()) {
            std::printf("%*.1f", width_of(engine), geometric_mean(times));
        }
    }
    std::printf("%11.2f\n\n", geometric_mean(lift));
}

void print_costs(const Results& results, const char* engine) {
    std::vector<QueryStatistics> work;
    for (std::size_t i = 0; i < results.pairs.size(); ++i) {
        work.push_back(results.find(i, engine, Query::all)->work.value());
    }
    const std::vector<double> times = results.least_times(engine, Query::all);
    const CostModel costs = fit_costs(work, times);
    std::printf("%s: Cv = %.2f ns, Cp = %.2f ns, Cu = %.2f ns\n", engine, 1e3 * costs.cv, 1e3 * costs.cp,
                1e3 * costs.cu);
    std::printf("%7s%10s%9s%9s%16s%15s\n", "pairs", "Nv", "Np", "Nu", "T predicted us", "T measured us");
    for (std::size_t i = 0; i < work.size(); ++i) {
        std::printf("%7zu%10llu%9llu%9llu%16.1f%15.1f\n", results.pairs[i],
                    static_cast<unsigned long long>(work[i].volume_tests),
                    static_cast<unsigned long long>(work[i].primitive_tests),
                    static_cast<unsigned long long>(work[i].transform_updates), costs.predict(work[i]),
                    times[i]);
    }
    std::printf("\n");
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_sphere_test(const Results& results) {
    std::printf("What the sphere test does (paper): share of the pairs of nodes that each layer separates\n");
    std::printf("%7s%10s%10s%10s%10s%13s\n", "pairs", "outer %", "inner %", "boxes %", "none %", "obb/paper");
    const std::vector<double> lift = multiples(results, "obb", "paper", Query::all);
    HybridContactStatistics sum;
    for (std::size_t i = 0; i < results.pairs.size(); ++i) {
        const HybridContactStatistics w = results.find(i, "paper", Query::all)->work.value();
        sum += w;
        sum.outer += w.outer;
        sum.inner += w.inner;
        sum.box += w.box;
        std::printf("%7zu%10.1f%10.1f%10.1f%10.1f%13.2f\n", results.pairs[i],
                    percent(w.outer, w.volume_tests), percent(w.inner, w.volume_tests),
                    percent(w.box, w.volume_tests),
                    percent(w.volume_tests - w.outer - w.inner - w.box, w.volume_tests), lift[i]);
    }
    std::uint64_t without = 0;
    for (std::size_t i = 0; i < results.pairs.size(); ++i) {
        without += results.find(i, "obb", Query::all)->work.value().volume_tests;
    }
    const auto [least, most] = std::minmax_element(lift.begin(), lift.end());
    const double mean = geometric_mean(lift);
    std::printf(
        "The outer spheres separate %.1f %% of the pairs of nodes, the inner spheres another %.1f %%.\n"
        "The boxes would separate nearly all of these: without spheres (obb) %.1f %% more pairs of\n"
        "nodes are tested. With spheres first, the same query on the same tree is %.2f times as fast\n"
        "(geometric mean; %.2f to %.2f)%s\n\n",
        percent(sum.outer, sum.volume_tests), percent(sum.inner, sum.volume_tests),
        percent(without, sum.volume_tests) - 100.0, mean, *least, *most,
        mean < 1.5 ? ":\nthe spheres alone don't make the tree twice as fast." : ".");
}

void print_sets(const Results& results) {
    std::printf("Pairs, compared with %s:\n", results.engines.front().name.c_str());
    for (const EngineName& engine : results.engines) {
        std::string differences;
        for (const Measurement& m : results.measurements) {
            if (results.engines[m.engine].name == engine.name && !m.difference.none()) {
                differences += (differences.empty() ? "" : ", ") +
                               std::to_string(results.pairs[m.placement]) +
                               (m.query == Query::first ? " (first)" : "") + ": " + to_string(m.difference);
            }
        }
        std::printf("  %-15s %s\n", engine.name.c_str(),
                    differences.empty() ? "the same in every placement" : differences.c_str());
    }
}

/// Prints our measurements of Table I, the costs of eq. (4), the effect of the sphere test, and how the
/// engines' pairs differ.
void print_table1(const Results& results) {
    std::printf(
        "Table I. Microseconds per query, the least of %d, one thread; obb/paper is the paper's\n"
        "efficiency lifting multiple; the last row holds geometric means.\n\nAll pairs\n",
        results.rounds);
    print_times(results, Query::all);
    std::printf("First pair\n");
    print_times(results, Query::first);
    std::printf(
        "Eq. (4), T = Nv Cv + Np Cp + Nu Cu. The costs are fitted to these ten times (least squares of\n"
        "relative errors, none negative). All three counts rise together: their sum is well determined, the\n"
        "share of each isn't.\n\n");
    for (const char* engine : {"paper", "obb", "sphere", "mixed"}) {
        if (results.find(0, engine, Query::all) != nullptr) {
            print_costs(results, engine);
        }
    }
    print_sphere_test(results);
    print_sets(results);
}

}  // namespace

CaseResult run_table1(int rounds, bool mixed, const std::filesystem::path& plot) {
    std::vector<const char*> names = {"paper", "obb", "sphere"};
    if (mixed) {
        names.push_back("mixed");
    }
    names.insert(names.end(), {"wide_sse42", "wide_avx2", "wide_avx512", "fcl_obb", "bullet_gimpact", "ode",
                               "embree", "cgal"});
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
