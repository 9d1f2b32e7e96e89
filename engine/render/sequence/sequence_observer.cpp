#include "engine/render/sequence/sequence_observer.h"

#include <cmath>
#include <utility>

namespace campuswalk::engine::render {
namespace {

constexpr double kRounding = 1e-9;  ///< of a time, in times of `every`

}  // namespace

SequenceObserver::SequenceObserver(const scene::Campus& campus, SequenceSettings settings,
                                   RendererStore& renderers, std::vector<std::unique_ptr<FrameSink>> sinks,
                                   std::unique_ptr<FrameSource> others)
    : campus_(campus),
      settings_(std::move(settings)),
      renderers_(renderers),
      others_(std::move(others)),
      queue_(std::move(sinks), others_.get(), settings_.share.parts) {}

void SequenceObserver::begin(const Walk& walk) {
    requests_.begin(walk);
}

void SequenceObserver::frame(const TickRecord& record) {
    requests_.follow(record.avatar);
    if (!is_due(record.time)) {
        return;
    }
    const std::size_t number = taken_++;
    if (settings_.share.has(number)) {
        SnapshotRenderer& snapshot_renderer = renderers_.of(campus_, requests_.light());
        queue_.add(
            {snapshot_renderer.draw(requests_.request(record, settings_.camera)), number, record.time});
    } else if (others_) {
        queue_.add_remote(number);
    }
}

void SequenceObserver::end() {
    queue_.finish();
}

bool SequenceObserver::is_due(double time) {
    const double now = time / settings_.every + kRounding;
    if (now < next_) {
        return false;
    }
    next_ = std::floor(now) + 1.0;
    return true;
}

}  // namespace campuswalk::engine::render
