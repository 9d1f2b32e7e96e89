#include "tools/campuswalk_bench/draw/draw_ours.h"

#include <sys/resource.h>

#include <span>

#include "engine/render/image/png.h"
#include "engine/render/renderer.h"
#include "tools/campuswalk_bench/draw/looks.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

using engine::render::Image;
using engine::render::Renderer;
using engine::render::Viewpoint;

namespace {

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

}  // namespace

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

}  // namespace campuswalk::tools::bench
