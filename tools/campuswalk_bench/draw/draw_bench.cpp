#include "tools/campuswalk_bench/draw/draw_bench.h"

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/image/png.h"
#include "tools/campuswalk_bench/draw/draw_by_processes.h"
#include "tools/campuswalk_bench/draw/draw_ours.h"
#include "tools/campuswalk_bench/draw/draw_report.h"
#include "tools/campuswalk_bench/draw/looks.h"
#include "tools/campuswalk_bench/files/scratch_folder.h"
#include "tools/campuswalk_bench/files/write_glb.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

namespace {

/// A model to draw, the views of it, and the times of the processes that have drawn it.
struct Subject {
    std::string name;
    scene::Model model;
    std::vector<DrawnView> views;
    std::vector<DrawTimes> by_processes;
};

Subject hills(int lots) {
    const WalkableCampus campus = walkable_campus(lots);
    return {"hills", drawn_campus(campus.mesh, campus.runs, kWalkableLot), views_over_hills(campus), {}};
}

Subject houses(int lots) {
    const GeneratedCampus campus = generated_campus(lots);
    return {"houses",
            drawn_campus(campus.mesh, campus.runs, kGeneratedLot),
            views_among_houses(campus, lots),
            {}};
}

DrawnCampus draw_campus(const Subject& subject, const DrawBench& bench, const fs::path& folder) {
    const auto& [name, model, views, by_processes] = subject;
    fs::create_directories(folder);
    write_glb(model, folder / "campus.glb", [](const scene::Texture& texture) {
        return engine::render::encode_png(
            {texture.width, texture.height, {texture.rgba.begin(), texture.rgba.end()}});
    });
    write_views(views, bench.rounds, folder);
    DrawnCampus drawn;
    drawn.name = name;
    drawn.triangles = scene::count_triangles(model);
    std::printf(
        "\n%s: %zu triangles in %zu meshes, %zu views of %dx%d, %d rounds after one to warm up\n"
        "processes: %zu of ours at the same time; an image's time is divided by their number\n",
        name.c_str(), drawn.triangles, model.meshes.size(), views.size(), kDrawnWidth, kDrawnHeight,
        bench.rounds, drawing_processes());
    std::fflush(stdout);
    OurDrawing ours = draw_ours(model, views, bench.rounds, folder);
    drawn.looks = std::move(ours.looks);
    drawn.looks.insert(drawn.looks.end(), by_processes.begin(), by_processes.end());
    drawn.encode_ms = ours.encode_ms;
    drawn.heap_bytes = ours.heap_bytes;
    for (const DrawPeer& peer : bench.peers) {
        try {
            std::vector<DrawTimes> theirs = draw_peer(peer, folder);
            drawn.looks.insert(drawn.looks.end(), theirs.begin(), theirs.end());
        } catch (const std::exception& error) {
            std::printf("  absent: %s: %s\n", peer.name.c_str(), error.what());
        }
    }
    print_draw_table(drawn);
    return drawn;
}

}  // namespace

bool can_draw() {
    return true;
}

void run_draw_bench(const DrawBench& bench) {
    const ScratchFolder scratch(bench.folder);
    // The drawing processes come first: they can't be forked from a process that has drawn.
    std::vector<Subject> subjects;
    for (const int lots : bench.quick ? std::vector<int>{1} : std::vector<int>{8, 17}) {
        for (const auto& make : {hills, houses}) {
            Subject& made = subjects.emplace_back(make(lots));
            made.by_processes = draw_by_processes(made.model, made.views, bench.rounds);
        }
    }
    std::vector<DrawnCampus> campuses;
    for (const Subject& made : subjects) {
        const std::string folder = made.name + "-" + std::to_string(scene::count_triangles(made.model));
        campuses.push_back(draw_campus(made, bench, scratch.path() / folder));
        std::fflush(stdout);
    }
    print_draw_verdicts(draw_verdicts(campuses));
    if (!bench.csv.empty()) {
        write_draw_csv(campuses, bench.csv);
    }
}

}  // namespace campuswalk::tools::bench
