#include "tools/campuswalk/bench/draw/draw_bench.h"

#include <cstdio>
#include <exception>
#include <string>

#include "engine/render/png.h"
#include "tools/campuswalk/bench/draw/draw_ours.h"
#include "tools/campuswalk/bench/draw/draw_report.h"
#include "tools/campuswalk/bench/scratch_folder.h"
#include "tools/campuswalk/bench/write_glb.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

namespace {

DrawnCampus draw_campus(int lots, const DrawBench& bench, const fs::path& folder) {
    const scene::WalkableCampus campus = scene::walkable_campus(lots);
    const std::vector<DrawnView> views = drawn_views(campus);
    const scene::Model model = drawn_campus(campus);
    fs::create_directories(folder);
    write_glb(model, folder / "campus.glb", [](const scene::Texture& texture) {
        return engine::render::encode_png(
            {texture.width, texture.height, {texture.rgba.begin(), texture.rgba.end()}});
    });
    write_views(views, bench.rounds, folder);
    DrawnCampus drawn;
    drawn.triangles = scene::count_triangles(model);
    std::printf("\n%zu triangles in %zu meshes, %zu views of %dx%d, %d rounds after one for warming up\n",
                drawn.triangles, model.meshes.size(), views.size(), kDrawnWidth, kDrawnHeight, bench.rounds);
    std::fflush(stdout);
    OurDrawing ours = draw_ours(model, views, bench.rounds, folder);
    drawn.looks = std::move(ours.looks);
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
    std::vector<DrawnCampus> campuses;
    for (const int lots : bench.quick ? std::vector<int>{1} : std::vector<int>{8, 17}) {
        campuses.push_back(draw_campus(lots, bench, scratch.path() / std::to_string(lots)));
        std::fflush(stdout);
    }
    print_draw_verdicts(draw_verdicts(campuses));
    if (!bench.csv.empty()) {
        write_draw_csv(campuses, bench.csv);
    }
}

}  // namespace campuswalk::tools::bench
