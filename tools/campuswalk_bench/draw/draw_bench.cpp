#include "tools/campuswalk_bench/draw/draw_bench.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <sys/resource.h>

#include "engine/render/gl/driver_threads.h"
#include "engine/render/image/png.h"
#include "engine/render/renderer.h"
#include "scene/base/atomic_file.h"
#include "scene/export/named_glb.h"
#include "scene/model/model.h"
#include "tools/campuswalk/run/cases/frame_helpers.h"
#include "tools/campuswalk/run/workers/worker.h"
#include "tools/campuswalk_bench/draw/draw_peers.h"
#include "tools/campuswalk_bench/draw/draw_report.h"
#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"
#include "tools/campuswalk_bench/draw/looks.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/files/scratch_folder.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;
using engine::render::Image;
using engine::render::Renderer;
using engine::render::Viewpoint;

namespace {

constexpr std::size_t kWarmUp = 0;
constexpr std::size_t kDraw = 1;

/// Returns the number of processors, at most eight.
std::size_t drawing_processes() {
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, FrameHelpers::kMaxParts);
}

/// One of the processes: makes a renderer and draws all views once, then once per timed round.
class Drawer {
public:
    Drawer(const scene::Model& model, const Look& look, const std::vector<Viewpoint>& views, int rounds,
           std::size_t first)
        : model_(model), look_(look), views_(views), rounds_(rounds), first_(first) {}

    void work(std::size_t task, const Send& send) {
        std::ostringstream lines;
        try {
            if (task == kWarmUp) {
                engine::render::share_processors(drawing_processes());
                renderer_ = std::make_unique<Renderer>(std::span(&model_, 1), look_.settings);
            }
            for (int round = 0; round < (task == kWarmUp ? 1 : rounds_); ++round) {
                draw_views(lines);
            }
        } catch (const std::exception& error) {
            send(Topic::log, error.what());
        }
        send(Topic::result, lines.str());
    }

private:
    // Each process begins with a different view; otherwise all would draw the expensive ones at the same
    // time.
    void draw_views(std::ostringstream& lines) {
        for (std::size_t i = 0; i < views_.size(); ++i) {
            const std::size_t view = (first_ + i) % views_.size();
            const double us =
                microseconds_of([&] { renderer_->draw(views_[view], kDrawnWidth, kDrawnHeight); });
            lines << view << ' ' << 1e-3 * us << '\n';
        }
    }

    const scene::Model& model_;
    const Look& look_;
    const std::vector<Viewpoint>& views_;
    int rounds_;
    std::size_t first_;
    std::unique_ptr<Renderer> renderer_;
};

/// All workers do the task. Returns their results.
std::string wait_for(std::vector<Worker>& workers, std::size_t task) {
    for (Worker& worker : workers) {
        worker.give(task);
    }
    std::string all;
    for (Worker& worker : workers) {
        const Message message = worker.wait_for_message("draws");
        if (message.topic == Topic::log) {
            throw std::runtime_error(message.body);
        }
        all += message.body;
    }
    return all;
}

DrawTimes draw_look(const scene::Model& model, const Look& look, const std::vector<Viewpoint>& views,
                    int rounds) {
    std::vector<Worker> workers;
    for (std::size_t i = 0; i < drawing_processes(); ++i) {
        const StartWork start = [&, first = i * views.size() / drawing_processes()] {
            const auto drawer = std::make_shared<Drawer>(model, look, views, rounds, first);
            return [drawer](std::size_t task, const Send& send) { drawer->work(task, send); };
        };
        workers.emplace_back(start, workers);
    }
    wait_for(workers, kWarmUp);
    DrawTimes times;
    times.engine = kOurProcesses;
    times.look = look.name;
    std::istringstream lines(wait_for(workers, kDraw));
    TimedImage image;
    while (lines >> image.view >> image.ms) {
        image.ms /= static_cast<double>(drawing_processes());
        times.images.push_back(image);
    }
    return times;
}

/// Draws the views in each look in drawing_processes() at the same time, as the video frames of a walk are
/// drawn. Each process draws all views `rounds` times after once to warm up. An image's time is divided by
/// the number of processes: that is what the image adds to a walk. Must be called before this process draws
/// anything. Throws std::runtime_error when the machine can't draw.
std::vector<DrawTimes> draw_by_processes(const scene::Model& model, const std::vector<DrawnView>& views,
                                         int rounds) {
    const std::vector<Viewpoint> points = viewpoints(views);
    const std::vector<Look> all_looks = looks();
    std::vector<DrawTimes> all;
    all.reserve(all_looks.size());
    for (const Look& look : all_looks) {
        all.push_back(draw_look(model, look, points, rounds));
    }
    return all;
}

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

DrawnCampus draw_campus(const Subject& subject, int rounds, const std::vector<std::string>& peers,
                        const fs::path& folder) {
    const auto& [name, model, views, by_processes] = subject;
    fs::create_directories(folder);
    std::vector<std::string> images;
    for (const scene::Texture& texture : model.textures) {
        const auto png = engine::render::encode_png(
            {texture.width, texture.height, {texture.rgba.begin(), texture.rgba.end()}});
        images.emplace_back(png.begin(), png.end());
    }
    scene::write_file_atomically(folder / "campus.glb", scene::write_named_glb(model, images));
    write_views(views, rounds, folder);
    DrawnCampus drawn;
    drawn.name = name;
    drawn.triangles = scene::count_triangles(model);
    std::printf(
        "\n%s: %zu triangles in %zu meshes, %zu views of %dx%d, %d rounds after one to warm up\n"
        "processes: %zu of ours at the same time; an image's time is divided by their number\n",
        name.c_str(), drawn.triangles, model.meshes.size(), views.size(), kDrawnWidth, kDrawnHeight, rounds,
        drawing_processes());
    std::fflush(stdout);
    OurDrawing ours = draw_ours(model, views, rounds, folder);
    drawn.looks = std::move(ours.looks);
    drawn.looks.insert(drawn.looks.end(), by_processes.begin(), by_processes.end());
    drawn.encode_ms = ours.encode_ms;
    drawn.heap_bytes = ours.heap_bytes;
    for (const std::string& peer : peers) {
        const std::size_t equals = peer.find('=');
        const std::string peer_name = peer.substr(0, equals);
        unless_absent(peer_name.c_str(), [&] {
            const std::vector<DrawTimes> theirs = draw_peer(peer_name, peer.substr(equals + 1), folder);
            drawn.looks.insert(drawn.looks.end(), theirs.begin(), theirs.end());
        });
    }
    print_draw_table(drawn);
    return drawn;
}

}  // namespace

bool can_draw() {
    return true;
}

void run_draw_bench(int rounds, bool quick, const fs::path& csv, const DrawBench& bench) {
    const ScratchFolder scratch(bench.folder);
    // The drawing processes come first: they can't be forked from a process that has drawn.
    std::vector<Subject> subjects;
    for (const int lots : quick ? std::vector<int>{1} : std::vector<int>{8, 17}) {
        for (const auto& make : {hills, houses}) {
            Subject& made = subjects.emplace_back(make(lots));
            made.by_processes = draw_by_processes(made.model, made.views, rounds);
        }
    }
    std::vector<DrawnCampus> campuses;
    for (const Subject& made : subjects) {
        const std::string folder = made.name + "-" + std::to_string(scene::count_triangles(made.model));
        campuses.push_back(draw_campus(made, rounds, bench.peers, scratch.path() / folder));
        std::fflush(stdout);
    }
    print_draw_verdicts(draw_verdicts(campuses));
    if (!csv.empty()) {
        write_draw_csv(campuses, csv);
    }
}

}  // namespace campuswalk::tools::bench
