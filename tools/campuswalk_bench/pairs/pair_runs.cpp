#include "tools/campuswalk_bench/pairs/pair_runs.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

using collision::Pose;
using collision::TrianglePair;

namespace {

using Pairs = std::vector<TrianglePair>;

/// A measurement in progress.
struct Run {
    Measurement result;
    Pairs answer;  ///< of the last run; for query first: one pair or none
};

std::vector<Run> list_runs(std::size_t placements, const std::vector<NamedEngine>& engines) {
    std::vector<Run> runs;
    for (std::size_t placement = 0; placement < placements; ++placement) {
        for (std::size_t engine = 0; engine < engines.size(); ++engine) {
            for (const Query query : {Query::all, Query::first}) {
                if (query == Query::all || engines[engine].engine->stops_at_first()) {
                    Run run;
                    run.result.placement = placement;
                    run.result.engine = engine;
                    run.result.query = query;
                    runs.push_back(run);
                }
            }
        }
    }
    return runs;
}

void run_query(Run& run, Engine& engine, const Pose& X_a_b) {
    engine.set_pose(X_a_b);
    if (run.result.query == Query::all) {
        engine.all_pairs(run.answer);
    } else {
        const std::optional<TrianglePair> first = engine.first_pair();
        run.answer.assign(first ? 1U : 0U, first.value_or(TrianglePair{}));
    }
}

void normalise(Pairs& pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Both must be sorted.
Difference compare(const Pairs& answer, const Pairs& reference, Query query) {
    Pairs extra;
    std::set_difference(answer.begin(), answer.end(), reference.begin(), reference.end(),
                        std::back_inserter(extra));
    if (query == Query::first) {
        return {extra.size(), answer.empty() && !reference.empty() ? 1U : 0U};
    }
    return {extra.size(), reference.size() - (answer.size() - extra.size())};
}

/// Fills in the differences. Returns the reference's number of pairs by placement.
std::vector<std::size_t> compare_with_reference(std::vector<Run>& runs) {
    std::vector<std::size_t> found;
    const Pairs* reference = nullptr;
    for (Run& run : runs) {
        normalise(run.answer);
        if (run.result.engine == 0 && run.result.query == Query::all) {
            reference = &run.answer;
            found.push_back(reference->size());
        }
        run.result.difference = compare(run.answer, *reference, run.result.query);
    }
    return found;
}

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

Results measure(const PairScene& scene, const std::vector<NamedEngine>& engines, int rounds) {
    std::vector<Run> runs = list_runs(scene.placements.size(), engines);
    const std::vector<Spread> spreads = shuffled_runs(runs.size(), rounds, [&](std::size_t i) {
        Run& run = runs[i];
        Engine& engine = *engines[run.result.engine].engine;
        const Pose& X_a_b = scene.placements[run.result.placement].X_a_b;
        const double microseconds = microseconds_of([&] { run_query(run, engine, X_a_b); });
        run.result.work = engine.work();
        return microseconds;
    });

    Results results;
    results.case_name = scene.name;
    results.found = compare_with_reference(runs);
    results.rounds = rounds;
    for (std::size_t i = 0; i < scene.placements.size(); ++i) {
        results.pairs.push_back(scene.placements[i].pairs.value_or(results.found[i]));
    }
    for (const NamedEngine& engine : engines) {
        results.engines.push_back({engine.name, engine.is_ours});
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        runs[i].result.us_min = spreads[i].least;
        runs[i].result.us_median = spreads[i].median;
        results.measurements.push_back(runs[i].result);
    }
    return results;
}

bool report_our_errors(const PairScene& scene, const Results& results) {
    bool any = false;
    for (std::size_t i = 0; i < scene.placements.size(); ++i) {
        if (results.found[i] != results.pairs[i]) {
            any = true;
            std::fprintf(stderr, "error: %s: %s finds %zu pairs where there are %zu\n", scene.name.c_str(),
                         results.engines.front().name.c_str(), results.found[i], results.pairs[i]);
        }
    }
    for (const Measurement& m : results.measurements) {
        const EngineName& engine = results.engines[m.engine];
        if (engine.is_ours && !m.difference.none()) {
            any = true;
            std::fprintf(stderr, "error: %s: at %zu pairs %s differs from %s by %s\n", scene.name.c_str(),
                         results.pairs[m.placement], engine.name.c_str(),
                         results.engines.front().name.c_str(), to_string(m.difference).c_str());
        }
    }
    return any;
}

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
