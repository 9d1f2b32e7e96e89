#include "tools/campuswalk_bench/walk/walk_bench.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/simulation/simulation.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk_bench/explore/explored_campus.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"
#include "tools/campuswalk_bench/walk/walk_case.h"
#include "tools/campuswalk_bench/walk/walk_csv.h"
#include "tools/campuswalk_bench/walk/walk_verdicts.h"

namespace campuswalk::tools::bench {

namespace {

constexpr int kSeconds = 120;

void walk_two_minutes(const LoadedWalk& tour) {
    engine::Simulation simulation(*tour.campus, tour.walk);
    const engine::Tick last = kSeconds * static_cast<engine::Tick>(tour.walk.sim.ticks_per_second);
    engine::Tick tick = 0;
    while (tick < last) {
        if (simulation.finished()) {
            throw std::runtime_error("it ends before two minutes have passed");
        }
        tick = simulation.step().tick;
    }
}

/// The milliseconds of two minutes of the demo campus' tour at 60 Hz, the least of `rounds`: all ticks from
/// the spawn on, with events, with the campus in memory and without observers. Empty, with the reason
/// printed, where the demo's files are missing.
std::optional<double> time_demo_tour(int rounds) {
    try {
        WalkLoader loader;
        const LoadedWalk tour = loader.load_walk(demo_file("walks/first-tour.walk.yaml"));
        double least = 1e300;
        for (int round = 0; round < rounds; ++round) {
            least = std::min(least, microseconds_of([&] { walk_two_minutes(tour); }));
        }
        return 0.001 * least;
    } catch (const std::exception& error) {
        std::printf("  absent: the demo tour: %s\n", error.what());
        return std::nullopt;
    }
}

/// The microseconds of reading the clock, which are part of each tick's time.
double clock_overhead() {
    double least = 1e300;
    for (int i = 0; i < 1000; ++i) {
        least = std::min(least, microseconds_of([] {}));
    }
    return least;
}

}  // namespace

bool run_walk_bench(int rounds, bool quick, const std::filesystem::path& csv) {
    std::printf(
        "A person of 1.8 m at 1.4 m/s and 60 Hz, one thread. Reading the clock takes %.3f us of each tick.\n",
        clock_overhead());
    std::vector<WalkedCampus> campuses;
    for (const int lots : quick ? std::vector<int>{1} : std::vector<int>{3, 8, 17}) {
        campuses.push_back(walk_campus(lots, rounds));
        std::fflush(stdout);
    }
    const std::optional<double> tour_ms = time_demo_tour(rounds);
    for (const WalkedCampus& campus : campuses) {
        std::printf("Our mover's working memory on %zu triangles: %zu bytes\n", campus.triangles,
                    campus.working_memory);
    }
    std::printf("\nCompared with the targets; Bullet's is the faster of its two\n");
    print_verdicts(walk_verdicts(campuses, tour_ms));
    if (!csv.empty()) {
        write_walk_csv(campuses, csv);
    }
    return std::all_of(campuses.begin(), campuses.end(),
                       [](const WalkedCampus& campus) { return is_correct(campus.scores.front()); });
}

}  // namespace campuswalk::tools::bench
