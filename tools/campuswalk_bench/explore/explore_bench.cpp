#include "tools/campuswalk_bench/explore/explore_bench.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>

#include "engine/events/decimals.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk_bench/explore/explore_case.h"
#include "tools/campuswalk_bench/explore/explore_verdicts.h"

namespace campuswalk::tools::bench {

namespace {

/// Pairs that each arrives in, times of a query, and how long our routes are beside the peer's.
std::string routes_text(const std::optional<RouteScore>& routes, bool ours) {
    if (!routes || (!ours && !routes->peer)) {
        return ",,,";
    }
    const QueryTimes& times = ours ? routes->ours : *routes->peer;
    return std::to_string(ours ? routes->found + routes->found_else : routes->by_peer) + ',' +
           engine::fixed(times.median, 1) + ',' + engine::fixed(times.p99, 1) + ',' +
           (ours && routes->length_ratio ? engine::fixed(*routes->length_ratio, 4) : "");
}

std::string line(const ExploreScore& score, const ExploreTime& time) {
    const bool ours = time.engine == "ours";
    std::string text = score.campus + ',' + std::to_string(score.triangles) + ',' + time.engine + ',' +
                       std::to_string(time.threads) + ',' + engine::fixed(time.least, 4) + ',' +
                       engine::fixed(time.median, 4) + ',' + engine::fixed(time.processor, 4) + ',';
    if (ours) {
        text += engine::fixed(score.area, 1) + ',' + std::to_string(score.nodes) + ',' +
                std::to_string(score.ticks) + ',' +
                (score.bytes_per_area ? engine::fixed(*score.bytes_per_area, 1) : "") + ',' +
                (score.disagreement ? engine::fixed(score.disagreement->only_ours.area, 1) : "") + ',' +
                std::to_string(score.adversary.escapes.size()) + ',' +
                std::to_string(score.steered.escapes.size());
    } else if (time.engine == "report") {
        return text + ",,,,,,,,,,\n";
    } else {
        text += engine::fixed(score.disagreement->polygon_area, 1) + ",,,," +
                engine::fixed(score.disagreement->only_peer.area, 1) + ",,";
    }
    return text + ',' + routes_text(score.routes, ours) + '\n';
}

/// One line per campus, engine and number of threads. Throws std::runtime_error if it can't be written.
void write_explore_csv(const std::vector<ExploreScore>& scores, const std::filesystem::path& file) {
    std::string text =
        "campus,triangles,engine,threads,s_least,s_median,s_processor,reachable_m2,nodes,ticks,bytes_per_"
        "m2,"
        "m2_of_it_alone,walks_outside,steered_walks_outside,routes,us_route_median,us_route_p99,"
        "route_length_ratio\n";
    for (const ExploreScore& score : scores) {
        for (const ExploreTime& time : score.times) {
            text += line(score, time);
        }
    }
    scene::write_file_atomically(file, text);
}

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

bool run_explore_bench(int rounds, bool quick, const std::filesystem::path& csv, const ExploreBench& bench) {
    std::printf(
        "A person of 1.8 m at 60 Hz, slopes up to 50 degrees, from one spawn, cells of 0.25 m; Recast's\n"
        "whole build, tile by tile, with cells of 0.15 m and 0.1 m in height, without Detour's part.\n");
    std::vector<ExploredCampusSource> sources = explored_campuses(bench.data);
    if (quick) {
        sources = {small_explored_campus()};
    }
    const auto count = [](int n) { return static_cast<std::size_t>(n); };
    std::vector<ExploreScore> scores;
    for (const ExploredCampusSource& source : sources) {
        if (!is_wanted(bench, source.name)) {
            continue;
        }
        ExploreCaseSettings settings{rounds, count(bench.walks),
                                     count(source.name == kSteeredIn ? bench.steered_walks : 0),
                                     count(bench.routes)};
        if (quick) {
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
    if (!csv.empty()) {
        write_explore_csv(scores, csv);
    }
    return std::ranges::all_of(scores, is_correct);
}

}  // namespace campuswalk::tools::bench
