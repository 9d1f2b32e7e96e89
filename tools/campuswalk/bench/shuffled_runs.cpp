#include "tools/campuswalk/bench/shuffled_runs.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <random>

namespace campuswalk::tools::bench {

using collision::Pose;
using collision::TrianglePair;

namespace {

using Pairs = std::vector<TrianglePair>;

/// A measurement in the making.
struct Run {
    Measurement result;
    std::vector<double> times;
    Pairs answer;  ///< of the last time; query first: one pair or none
};

std::vector<Run> list_runs(const scene::Table1Scene& scene, const std::vector<NamedEngine>& engines) {
    std::vector<Run> runs;
    for (std::size_t placement = 0; placement < scene.placements.size(); ++placement) {
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

double microseconds(Run& run, Engine& engine, const Pose& X_a_b) {
    const auto start = std::chrono::steady_clock::now();
    engine.set_pose(X_a_b);
    if (run.result.query == Query::all) {
        engine.all_pairs(run.answer);
    } else {
        const std::optional<TrianglePair> first = engine.first_pair();
        run.answer.assign(first ? 1U : 0U, first.value_or(TrianglePair{}));
    }
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// Fisher and Yates; std::shuffle's order is each library's own.
void shuffle(std::vector<std::size_t>& order, std::mt19937& chance) {
    for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[chance() % i]);
    }
}

void normalise(Pairs& pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Both sorted.
Difference compare(const Pairs& answer, const Pairs& right, Query query) {
    Pairs extra;
    std::set_difference(answer.begin(), answer.end(), right.begin(), right.end(), std::back_inserter(extra));
    if (query == Query::first) {
        return {extra.size(), answer.empty() && !right.empty() ? 1U : 0U};
    }
    return {extra.size(), right.size() - (answer.size() - extra.size())};
}

/// Fills in the results; returns how many pairs are right in each placement.
std::vector<std::size_t> conclude(std::vector<Run>& runs) {
    std::vector<std::size_t> found;
    const Pairs* right = nullptr;
    for (Run& run : runs) {
        normalise(run.answer);
        if (run.result.engine == 0 && run.result.query == Query::all) {
            right = &run.answer;
            found.push_back(right->size());
        }
        run.result.difference = compare(run.answer, *right, run.result.query);
        std::sort(run.times.begin(), run.times.end());
        run.result.us_min = run.times.front();
        run.result.us_median = run.times[run.times.size() / 2];
    }
    return found;
}

}  // namespace

Results measure(const scene::Table1Scene& scene, const std::vector<NamedEngine>& engines, int rounds) {
    std::vector<Run> runs = list_runs(scene, engines);
    std::vector<std::size_t> order(runs.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::mt19937 chance(1975);
    for (int round = 0; round < rounds; ++round) {
        shuffle(order, chance);
        for (const std::size_t i : order) {
            Run& run = runs[i];
            Engine& engine = *engines[run.result.engine].engine;
            const Pose& X_a_b = scene.placements[run.result.placement].X_cylinder_teapot;
            microseconds(run, engine, X_a_b);
            run.times.push_back(microseconds(run, engine, X_a_b));
            run.result.work = engine.work();
        }
    }

    Results results;
    results.found = conclude(runs);
    results.rounds = rounds;
    for (const scene::Table1Placement& placement : scene.placements) {
        results.pairs.push_back(placement.pairs);
    }
    for (const NamedEngine& engine : engines) {
        results.engines.push_back({engine.name, engine.is_ours});
    }
    for (const Run& run : runs) {
        results.measurements.push_back(run.result);
    }
    return results;
}

}  // namespace campuswalk::tools::bench
