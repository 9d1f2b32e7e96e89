#include "tools/campuswalk_bench/walk/walk_run.h"

#include <algorithm>
#include <numeric>

#include "tools/campuswalk_bench/walk/walk_paths.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

/// The walks of one controller, and their score so far.
struct ControllerRun {
    Walker walker;
    WalkScore score;
    std::vector<double> us;  ///< by tick of all paths
    WalkRecord first;        ///< of the current path
    WalkRecord again;
    bool is_repeated = true;  ///< on the current path
};

bool are_same(const WalkRecord& a, const WalkRecord& b) {
    return std::equal(a.ticks.begin(), a.ticks.end(), b.ticks.begin(), b.ticks.end(),
                      [](const WalkTick& one, const WalkTick& other) { return one.foot == other.foot; });
}

void repeat(ControllerRun& run, const WalkPath& path, const WalkBody& body, int round) {
    walk_path(*run.walker.engine, path, body, run.again);
    if (round >= 2) {
        run.score.heap_growth = run.score.heap_growth.value_or(0) + run.again.heap_growth;
    }
    run.is_repeated = run.is_repeated && are_same(run.first, run.again);
    for (std::size_t i = 0; run.is_repeated && i < run.first.ticks.size(); ++i) {
        run.first.ticks[i].us = std::min(run.first.ticks[i].us, run.again.ticks[i].us);
    }
}

void score_motion(ControllerRun& run, const WalkBody& body, const WalkScorer& scorer) {
    const Vec3 middle(0.0, 0.5 * body.height, 0.0);
    Vec3 before = run.first.start;
    for (const WalkTick& tick : run.first.ticks) {
        run.score.max_penetration =
            std::max(run.score.max_penetration, scorer.penetration(tick.foot, body.radius, body.height));
        run.score.crossings += scorer.crosses(before + middle, tick.foot + middle) ? 1U : 0U;
        before = tick.foot;
        run.us.push_back(tick.us);
    }
}

void score_goals(ControllerRun& run, const WalkPath& path) {
    for (std::size_t i = 0; i < path.goals.size(); ++i) {
        const bool forbidden = path.goals[i].forbidden;
        const bool arrived = run.first.arrived[i] != 0;
        (forbidden ? run.score.forbidden_goals : run.score.goals) += 1;
        (forbidden ? run.score.forbidden_reached : run.score.reached) += arrived ? 1U : 0U;
        if (forbidden == arrived) {
            run.score.failures.push_back(path.name + ", goal " + std::to_string(i + 1));
        }
    }
}

void score_times(ControllerRun& run) {
    std::vector<double>& us = run.us;
    run.score.ticks = us.size();
    if (us.empty()) {
        return;
    }
    std::sort(us.begin(), us.end());
    run.score.us_mean = std::accumulate(us.begin(), us.end(), 0.0) / static_cast<double>(us.size());
    run.score.us_p50 = us[us.size() / 2];
    run.score.us_p99 = us[us.size() * 99 / 100];
    run.score.us_max = us.back();
}

/// In a different order each round, so that no controller always follows the same one.
void walk_in_turns(std::vector<ControllerRun>& all, const WalkPath& path, const WalkBody& body, int rounds) {
    for (ControllerRun& run : all) {
        run.first = empty_record(path, body);
        run.again = empty_record(path, body);
        run.is_repeated = true;
        walk_path(*run.walker.engine, path, body, run.first);
    }
    for (int round = 1; round < rounds; ++round) {
        for (std::size_t turn = 0; turn < all.size(); ++turn) {
            repeat(all[(turn + static_cast<std::size_t>(round)) % all.size()], path, body, round);
        }
    }
}

}  // namespace

std::vector<WalkScore> run_walks(const std::vector<Walker>& walkers, const std::vector<WalkPath>& paths,
                                 const WalkBody& body, const WalkScorer& scorer, int rounds) {
    std::vector<ControllerRun> all;
    for (const Walker& walker : walkers) {
        all.emplace_back().walker = walker;
        all.back().score.controller = walker.name;
    }
    for (const WalkPath& path : paths) {
        walk_in_turns(all, path, body, rounds);
        for (ControllerRun& run : all) {
            score_motion(run, body, scorer);
            score_goals(run, path);
            run.score.differing_paths += run.is_repeated ? 0U : 1U;
        }
    }
    std::vector<WalkScore> scores;
    for (ControllerRun& run : all) {
        score_times(run);
        scores.push_back(run.score);
    }
    return scores;
}

}  // namespace campuswalk::tools::bench
