#include "tools/campuswalk_bench/draw/draw_bench.h"

#include <sys/resource.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/image/png.h"
#include "engine/render/renderer.h"
#include "scene/model/model.h"
#include "tools/campuswalk_bench/draw/draw_by_processes.h"
#include "tools/campuswalk_bench/draw/draw_report.h"
#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"
#include "tools/campuswalk_bench/draw/looks.h"
#include "tools/campuswalk_bench/files/scratch_folder.h"
#include "tools/campuswalk_bench/files/write_glb.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

using engine::render::Image;
using engine::render::Renderer;
using engine::render::Viewpoint;

namespace {

struct OurDrawing {
    std::vector<DrawTimes> looks;
    double encode_ms = 0.0;      ///< to encode an image as PNG; in a walk, this runs in parallel with drawing
    std::size_t heap_bytes = 0;  ///< allocated besides the model: geometry, textures, maps, targets
};

/// The processor time of all threads of this process.
double cpu_ms() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto ms = [](const timeval& t) {
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

DrawTimes draw_look(Renderer& renderer, const std::vector<Viewpoint>& views, int rounds) {
    DrawTimes times;
    double start = 0.0;
    for (int round = 0; round <= rounds; ++round) {
        if (round == 1) {
            start = cpu_ms();
        }
        for (std::size_t i = 0; i < views.size(); ++i) {
            const double us = microseconds_of([&] { renderer.draw(views[i], kDrawnWidth, kDrawnHeight); });
            if (round > 0) {
                times.images.push_back({i, 1e-3 * us});
            }
        }
    }
    times.cpu_ms = (cpu_ms() - start) / static_cast<double>(times.images.size());
    return times;
}

/// Draws the views in each look: once to warm up, then `rounds` times. The first view is saved as
/// `folder`/campuswalk-LOOK.png. Throws RenderError when the machine can't draw.
OurDrawing draw_ours(const scene::Model& model, const std::vector<DrawnView>& views, int rounds,
                     const std::filesystem::path& folder) {
    OurDrawing drawing;
    const std::vector<Viewpoint> points = viewpoints(views);
    for (const Look& look : looks()) {
        const std::size_t before = heap_in_use();
        Renderer renderer(std::span(&model, 1), look.settings);
        drawing.looks.push_back(draw_look(renderer, points, rounds));
        drawing.looks.back().engine = kOurs;
        drawing.looks.back().look = look.name;
        drawing.heap_bytes = heap_in_use() - before;
        const Image image = renderer.draw(points.front(), kDrawnWidth, kDrawnHeight);
        drawing.encode_ms = 1e-3 * microseconds_of([&] { engine::render::encode_png(image); });
        engine::render::write_png(image, folder / ("campuswalk-" + look.name + ".png"));
    }
    return drawing;
}

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
