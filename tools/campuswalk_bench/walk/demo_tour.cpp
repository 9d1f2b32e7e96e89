#include "tools/campuswalk_bench/walk/demo_tour.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "engine/simulation/simulation.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

namespace {

constexpr int kSeconds = 120;

/// Beside the program's avatars, or else below the current folder.
std::filesystem::path tour_file() {
    const std::filesystem::path name = "walks/first-tour.walk.yaml";
    for (const std::filesystem::path& avatars : search_paths().avatars) {
        std::error_code ignored;
        if (auto file = avatars.parent_path() / name; std::filesystem::exists(file, ignored)) {
            return file;
        }
    }
    return "config" / name;
}

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

}  // namespace

std::optional<double> time_demo_tour(int rounds) {
    try {
        WalkLoader loader;
        const LoadedWalk tour = loader.load_walk(tour_file());
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

}  // namespace campuswalk::tools::bench
