#include "tools/campuswalk_bench/explore/explore_bench.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "tools/campuswalk_bench/explore/explore_case.h"
#include "tools/campuswalk_bench/explore/explore_csv.h"
#include "tools/campuswalk_bench/explore/explore_verdicts.h"

namespace campuswalk::tools::bench {

namespace {

/// Where falls are deep and many.
constexpr const char* kSteeredIn = "dungeon";
constexpr std::size_t kQuickWalks = 20;

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

bool is_wanted(const ExploreBench& bench, const std::string& name) {
    return bench.campuses.empty() || has(bench.campuses, name);
}

}  // namespace

bool run_explore_bench(const ExploreBench& bench) {
    std::printf(
        "A person of 1.8 m at 60 Hz, slopes up to 50 degrees, from one spawn, cells of 0.25 m; Recast's\n"
        "whole build, tile by tile, with cells of 0.15 m and 0.1 m in height, without Detour's part.\n");
    std::vector<ExploredCampusSource> sources = explored_campuses(bench.data);
    if (bench.quick) {
        sources = {small_explored_campus()};
    }
    std::vector<ExploreScore> scores;
    for (const ExploredCampusSource& source : sources) {
        if (!is_wanted(bench, source.name)) {
            continue;
        }
        ExploreCaseSettings settings{bench.rounds, bench.walks, 0, bench.routes};
        if (source.name == kSteeredIn) {
            settings.steered_walks = bench.steered_walks;
        }
        if (bench.quick) {
            settings.walks = settings.steered_walks = settings.routes = kQuickWalks;
        }
        try {
            ExploredCampus campus = source.load();
            campus.run = has(bench.allow, "run");
            campus.jump = has(bench.allow, "jump");
            scores.push_back(explore_campus(campus, settings));
        } catch (const std::exception& error) {
            std::printf("\n  absent: %s: %s\n", source.name.c_str(), error.what());
        }
    }
    std::printf("\nCompared with the targets; times are geometric means of all campuses\n");
    print_verdicts(explore_verdicts(scores));
    if (!bench.csv.empty()) {
        write_explore_csv(scores, bench.csv);
    }
    return std::ranges::all_of(scores, is_correct);
}

}  // namespace campuswalk::tools::bench
