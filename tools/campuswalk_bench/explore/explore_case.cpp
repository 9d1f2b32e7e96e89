#include "tools/campuswalk_bench/explore/explore_case.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <utility>

#include "engine/walkspace/report/walk_report.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/explore/solid_triangles.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

using engine::WalkSpace;

namespace {

constexpr std::size_t kMostThreads = 2;
constexpr std::size_t kClustersShown = 5;
constexpr std::size_t kEscapesShown = 10;

WalkBody body_of(const ExploredCampus& campus) {
    WalkBody body;
    body.radius = campus.avatar.radius;
    body.height = campus.avatar.height;
    body.step_height = campus.avatar.step_height;
    body.max_slope = campus.avatar.max_slope;
    body.speed = campus.avatar.speed;
    return body;
}

/// By number of threads from one on; empty, with the reason printed, if Recast isn't built.
std::vector<std::unique_ptr<NavMeshEngine>> make_peers(const ExploredCampus& campus,
                                                       const collision::TriangleMesh& triangles) {
    std::vector<std::unique_ptr<NavMeshEngine>> peers;
    NavMeshSettings settings;
    settings.body = body_of(campus);
    unless_absent("recast", [&] {
        for (settings.threads = 1; settings.threads <= kMostThreads; ++settings.threads) {
            peers.push_back(make_peer<MakeNavMeshEngine>("recast", kMakeNavMeshEngine, triangles, settings));
        }
    });
    return peers;
}

struct Task {
    ExploreTime time;
    std::function<void()> run;
    std::vector<double> seconds;
    std::vector<double> processor;
};

void add_task(std::vector<Task>& tasks, const char* engine, std::size_t threads, std::function<void()> run) {
    Task& task = tasks.emplace_back();
    task.time.engine = engine;
    task.time.threads = threads;
    task.run = std::move(run);
}

/// Each in turn, in another order each round, so that a slowdown of the machine affects all of them.
void run_in_turns(std::vector<Task>& tasks, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t turn = 0; turn < tasks.size(); ++turn) {
            Task& task = tasks[(turn + static_cast<std::size_t>(round)) % tasks.size()];
            const std::clock_t before = std::clock();
            task.seconds.push_back(1e-6 * microseconds_of(task.run));
            task.processor.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
        }
    }
    for (Task& task : tasks) {
        std::ranges::sort(task.seconds);
        std::ranges::sort(task.processor);
        task.time.least = task.seconds.front();
        task.time.median = task.seconds[task.seconds.size() / 2];
        task.time.processor = task.processor[task.processor.size() / 2];
    }
}

/// In a run of its own, as counting takes time.
std::optional<double> bytes_per_area(const ExploredCampus& campus) {
    const std::size_t before = heap_in_use();
    std::size_t peak = before;
    engine::ExploreSettings settings = campus.settings();
    settings.progress = [&](std::size_t) { peak = std::max(peak, heap_in_use()); };
    const WalkSpace space = explore(campus.worlds(1), settings);
    if (before == 0 || space.node_count() == 0) {
        return std::nullopt;
    }
    return static_cast<double>(peak - before) / space.area();
}

bool are_same(const WalkSpace& a, const WalkSpace& b) {
    return a.node_count() == b.node_count() && a.ticks == b.ticks && a.strides == b.strides &&
           a.bounds == b.bounds && a.touched == b.touched;
}

void print_one_sided(const char* who, const OneSided& found) {
    std::printf("  only %s: %.1f m2 in %zu patches\n", who, found.area, found.clusters.size());
    for (std::size_t i = 0; i < std::min(kClustersShown, found.clusters.size()); ++i) {
        const Cluster& c = found.clusters[i];
        std::printf("    %8.2f m2 at %.2f, %.2f, %.2f, within %.2f..%.2f, %.2f..%.2f, %.2f..%.2f\n",
                    0.0625 * static_cast<double>(c.cells), c.at.x(), c.at.y(), c.at.z(), c.bounds.min.x(),
                    c.bounds.max.x(), c.bounds.min.y(), c.bounds.max.y(), c.bounds.min.z(), c.bounds.max.z());
    }
}

void print_escapes(const char* how, const AdversaryResult& result) {
    if (result.walks == 0) {
        return;
    }
    std::printf("  %zu walks%s, %llu ticks, %llu falls of more than 2 m: %zu got outside\n", result.walks,
                how, static_cast<unsigned long long>(result.ticks),
                static_cast<unsigned long long>(result.falls), result.escapes.size());
    for (std::size_t i = 0; i < std::min(kEscapesShown, result.escapes.size()); ++i) {
        const Escape& e = result.escapes[i];
        std::printf(
            "    seed %llu from %.3f, %.3f, %.3f: at tick %zu at %.3f, %.3f, %.3f; last left the ground at "
            "%.3f, %.3f, %.3f; %zu ticks, up to %.2f m away\n",
            static_cast<unsigned long long>(e.seed), e.start.x(), e.start.y(), e.start.z(), e.tick, e.at.x(),
            e.at.y(), e.at.z(), e.left_ground.x(), e.left_ground.y(), e.left_ground.z(), e.ticks_outside,
            e.apart);
    }
}

void print_time(const ExploreScore& score, const ExploreTime& time) {
    const ExploreTime* peer = score.time("recast", time.threads);
    std::printf("  %8s, %zu thread%s: %9.3f s (median; least %.3f; of the processor %.3f)",
                time.engine.c_str(), time.threads, time.threads == 1 ? " " : "s", time.median, time.least,
                time.processor);
    if (time.engine == "ours" && peer != nullptr) {
        std::printf(", %.2fx recast's (of the processor %.2fx)", time.median / peer->median,
                    time.processor / peer->processor);
    }
    if (time.engine == "report") {
        std::printf(": %.2fx reach", time.median / score.time("ours", time.threads)->median);
    }
    std::printf("\n");
}

void print_score(const ExploreScore& score) {
    std::printf("  ours: %.1f m2, %zu nodes, %llu ticks", score.area, score.nodes,
                static_cast<unsigned long long>(score.ticks));
    std::printf("%s\n", score.is_same_by_threads ? "" : "; DIFFERS with the number of threads");
    if (score.disagreement) {
        std::printf("  recast: %.1f m2\n", score.disagreement->polygon_area);
    }
    for (const ExploreTime& time : score.times) {
        print_time(score, time);
    }
    if (score.disagreement) {
        print_one_sided("ours", score.disagreement->only_ours);
        print_one_sided("recast", score.disagreement->only_peer);
    }
    print_escapes("", score.adversary);
    print_escapes(" that steer in falls", score.steered);
    std::fflush(stdout);
}

void print_memory(const ExploreScore& score) {
    if (score.bytes_per_area) {
        std::printf("  %.0f bytes/m2 at the peak\n", *score.bytes_per_area);
    }
}

void attack_all(const ExploredCampus& campus, const WalkSpace& space, const ExploreCaseSettings& settings,
                ExploreScore& score) {
    const engine::ExploreSettings explored = campus.settings();
    const engine::WorkerWorlds worlds = campus.worlds(kMostThreads);
    AdversarySettings walks;
    walks.walks = settings.walks;
    score.adversary = attack(space, worlds, explored, walks);
    walks.walks = settings.steered_walks;
    walks.steers_in_falls = true;
    score.steered = attack(space, worlds, explored, walks);
}

}  // namespace

const ExploreTime* ExploreScore::time(const std::string& engine, std::size_t threads) const {
    const auto found = std::ranges::find_if(
        times, [&](const ExploreTime& one) { return one.engine == engine && one.threads == threads; });
    return found == times.end() ? nullptr : &*found;
}

ExploreScore explore_campus(const ExploredCampus& campus, const ExploreCaseSettings& settings) {
    const collision::TriangleMesh triangles = solid_triangles(campus.world());
    std::printf("\n%s: %zu solids, %zu triangles; a step of %.2f m\n", campus.name.c_str(),
                campus.world().size(), triangles.triangles.size(), campus.avatar.step_height);
    const auto peers = make_peers(campus, triangles);
    std::vector<std::optional<WalkSpace>> spaces(kMostThreads);
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < kMostThreads; ++i) {
        add_task(tasks, "ours", i + 1, [&campus, &space = spaces[i], threads = i + 1] {
            space.emplace(explore(campus.worlds(threads), campus.settings()));
        });
    }
    for (std::size_t i = 0; i < kMostThreads; ++i) {
        add_task(tasks, "report", i + 1, [&campus, threads = i + 1] {
            engine::report_walks(*campus.campus, campus.avatar, campus.worlds(threads), campus.settings());
        });
    }
    for (std::size_t i = 0; i < peers.size(); ++i) {
        add_task(tasks, "recast", i + 1, [&peer = *peers[i]] { peer.build(); });
    }
    run_in_turns(tasks, settings.rounds);

    const WalkSpace& space = *spaces.front();
    ExploreScore score;
    score.campus = campus.name;
    score.triangles = triangles.triangles.size();
    score.area = space.area();
    score.nodes = space.node_count();
    score.ticks = space.ticks;
    score.is_same_by_threads = are_same(space, *spaces.back());
    for (Task& task : tasks) {
        score.times.push_back(std::move(task.time));
    }
    if (!peers.empty()) {
        std::vector<collision::Triangle> reachable;
        peers.front()->reachable_from(campus.spawn, reachable);
        score.disagreement = compare(space, reachable);
    }
    attack_all(campus, space, settings, score);
    spaces.back().reset();
    print_score(score);
    if (settings.routes > 0) {
        score.routes =
            route_pairs(campus, space, peers.empty() ? nullptr : peers.front().get(), settings.routes);
    }
    score.bytes_per_area = bytes_per_area(campus);
    print_memory(score);
    return score;
}

}  // namespace campuswalk::tools::bench
