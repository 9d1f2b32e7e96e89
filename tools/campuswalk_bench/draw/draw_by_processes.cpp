#include "tools/campuswalk_bench/draw/draw_by_processes.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "engine/render/gl/driver_threads.h"
#include "engine/render/renderer.h"
#include "tools/campuswalk/run/cases/frame_helpers.h"
#include "tools/campuswalk/run/workers/worker.h"
#include "tools/campuswalk_bench/draw/looks.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

using engine::render::Renderer;
using engine::render::Viewpoint;

namespace {

constexpr std::size_t kWarmUp = 0;
constexpr std::size_t kDraw = 1;

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

}  // namespace

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

std::size_t drawing_processes() {
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, FrameHelpers::kMaxParts);
}

}  // namespace campuswalk::tools::bench
