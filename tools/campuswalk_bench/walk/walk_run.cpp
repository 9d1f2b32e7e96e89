#include "tools/campuswalk_bench/walk/walk_run.h"

#include <algorithm>
#include <numeric>

#include "tools/campuswalk_bench/walk/walk_paths.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

/// A controller on its way, with what is to be known of all its ticks.
struct Contestant {
    Walker walker;
    WalkScore score;
    std::vector<double> us;  ///< by tick of all paths
    WalkRecord first;        ///< of the path at hand
    WalkRecord again;
    bool is_repeated = true;  ///< on the path at hand
};

bool are_same(const WalkRecord& a, const WalkRecord& b) {
    return std::equal(a.ticks.begin(), a.ticks.end(), b.ticks.begin(), b.ticks.end(),
                      [](const WalkTick& one, const WalkTick& other) { return one.foot == other.foot; });
}

void repeat(Contestant& it, const WalkPath& path, const WalkBody& body, int round) {
    walk_path(*it.walker.engine, path, body, it.again);
    if (round >= 2) {
        it.score.heap_growth = it.score.heap_growth.value_or(0) + it.again.heap_growth;
    }
    it.is_repeated = it.is_repeated && are_same(it.first, it.again);
    for (std::size_t i = 0; it.is_repeated && i < it.first.ticks.size(); ++i) {
        it.first.ticks[i].us = std::min(it.first.ticks[i].us, it.again.ticks[i].us);
    }
}

void evaluate_motion(Contestant& it, const WalkBody& body, const WalkEvaluator& evaluator) {
    const Vec3 middle(0.0, 0.5 * body.height, 0.0);
    Vec3 before = it.first.start;
    for (const WalkTick& tick : it.first.ticks) {
        it.score.max_penetration =
            std::max(it.score.max_penetration, evaluator.penetration(tick.foot, body.radius, body.height));
        it.score.crossings += evaluator.crosses(before + middle, tick.foot + middle) ? 1U : 0U;
        before = tick.foot;
        it.us.push_back(tick.us);
    }
}

void evaluate_goals(Contestant& it, const WalkPath& path) {
    for (std::size_t i = 0; i < path.goals.size(); ++i) {
        const bool forbidden = path.goals[i].forbidden;
        const bool arrived = it.first.arrived[i] != 0;
        (forbidden ? it.score.walled_off : it.score.goals) += 1;
        (forbidden ? it.score.forbidden : it.score.reached) += arrived ? 1U : 0U;
        if (forbidden == arrived) {
            it.score.failures.push_back(path.name + ", goal " + std::to_string(i + 1));
        }
    }
}

void conclude(Contestant& it) {
    std::vector<double>& us = it.us;
    it.score.ticks = us.size();
    if (us.empty()) {
        return;
    }
    std::sort(us.begin(), us.end());
    it.score.us_mean = std::accumulate(us.begin(), us.end(), 0.0) / static_cast<double>(us.size());
    it.score.us_p50 = us[us.size() / 2];
    it.score.us_p99 = us[us.size() * 99 / 100];
    it.score.us_max = us.back();
}

/// In another order each round, so that nobody always comes after the same.
void walk_by_turns(std::vector<Contestant>& all, const WalkPath& path, const WalkBody& body, int rounds) {
    for (Contestant& it : all) {
        it.first = empty_record(path, body);
        it.again = empty_record(path, body);
        it.is_repeated = true;
        walk_path(*it.walker.engine, path, body, it.first);
    }
    for (int round = 1; round < rounds; ++round) {
        for (std::size_t turn = 0; turn < all.size(); ++turn) {
            repeat(all[(turn + static_cast<std::size_t>(round)) % all.size()], path, body, round);
        }
    }
}

}  // namespace

std::vector<WalkScore> run_walks(const std::vector<Walker>& walkers, const std::vector<WalkPath>& paths,
                                 const WalkBody& body, const WalkEvaluator& evaluator, int rounds) {
    std::vector<Contestant> all;
    for (const Walker& walker : walkers) {
        all.emplace_back().walker = walker;
        all.back().score.controller = walker.name;
    }
    for (const WalkPath& path : paths) {
        walk_by_turns(all, path, body, rounds);
        for (Contestant& it : all) {
            evaluate_motion(it, body, evaluator);
            evaluate_goals(it, path);
            it.score.unrepeated += it.is_repeated ? 0U : 1U;
        }
    }
    std::vector<WalkScore> scores;
    for (Contestant& it : all) {
        conclude(it);
        scores.push_back(it.score);
    }
    return scores;
}

}  // namespace campuswalk::tools::bench
