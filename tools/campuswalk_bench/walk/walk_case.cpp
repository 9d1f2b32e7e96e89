#include "tools/campuswalk_bench/walk/walk_case.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"
#include "tools/campuswalk_bench/walk/our_walker.h"

namespace campuswalk::tools::bench {

namespace {

using Peers = std::vector<std::pair<const char*, std::unique_ptr<WalkEngine>>>;

Peers make_peers(const collision::TriangleMesh& mesh, const WalkBody& body) {
    Peers made;
    for (const auto& [name, function] :
         {std::pair("bullet_default", kMakeWalkEngine), std::pair("bullet_tuned", kMakeTunedWalkEngine)}) {
        unless_absent(name, [&, name = name, function = function] {
            made.emplace_back(name, make_peer<MakeWalkEngine>("bullet_character", function, mesh, body));
        });
    }
    return made;
}

void print_score(const WalkScore& score) {
    std::printf("%16s%9.3f%9.3f%9.3f%9.3f%9zu%6zu/%-5zu%5zu/%-5zu%9.3f%10zu%9zu\n", score.controller.c_str(),
                score.us_mean, score.us_p50, score.us_p99, score.us_max, score.ticks, score.reached,
                score.goals, score.forbidden_reached, score.forbidden_goals, 1000.0 * score.max_penetration,
                score.crossings, score.differing_paths);
}

void print_failures(const WalkScore& score) {
    constexpr std::size_t kMax = 8;
    for (std::size_t i = 0; i < std::min(kMax, score.failures.size()); ++i) {
        std::printf("%16s    %s\n", "", score.failures[i].c_str());
    }
    if (score.failures.size() > kMax) {
        std::printf("%16s    and %zu more\n", "", score.failures.size() - kMax);
    }
}

std::size_t correct_goals(const WalkScore& score) {
    return score.reached + score.forbidden_goals - score.forbidden_reached;
}

}  // namespace

const WalkScore& better(const WalkScore& a, const WalkScore& b) {
    if (correct_goals(a) != correct_goals(b)) {
        return correct_goals(a) > correct_goals(b) ? a : b;
    }
    return a.us_mean <= b.us_mean ? a : b;
}

WalkedCampus walk_campus(int lots, int rounds) {
    const WalkableCampus campus = walkable_campus(lots);
    const WalkBody body;
    WalkedCampus walked;
    walked.triangles = campus.mesh.triangles.size();
    std::printf("%zu triangles, %zu paths; microseconds per tick, the least of %d\n", walked.triangles,
                campus.paths.size(), rounds);
    const Peers peers = make_peers(campus.mesh, body);
    OurWalker ours(campus.mesh, body);
    std::vector<Walker> walkers{{"ours", &ours}};
    for (const auto& [name, engine] : peers) {
        walkers.push_back({name, engine.get()});
    }
    walked.scores = run_walks(walkers, campus.paths, body, WalkScorer(campus.mesh), rounds);
    walked.working_memory = ours.release_working_memory();
    if (walked.scores.size() == 3) {
        WalkScore best = better(walked.scores[1], walked.scores[2]);
        best.controller = "bullet";
        walked.fastest_peer = std::min(walked.scores[1].us_mean, walked.scores[2].us_mean);
        walked.scores.insert(walked.scores.begin() + 1, best);
    }
    std::printf("%16s%9s%9s%9s%9s%9s%12s%11s%9s%10s%9s\n", "", "mean", "p50", "p99", "max", "ticks",
                "reached", "forbidden", "deep, mm", "crossings", "differ");
    for (const WalkScore& score : walked.scores) {
        print_score(score);
    }
    std::printf("our goals missed, and forbidden goals reached: %zu\n",
                walked.scores.front().failures.size());
    print_failures(walked.scores.front());
    return walked;
}

}  // namespace campuswalk::tools::bench
