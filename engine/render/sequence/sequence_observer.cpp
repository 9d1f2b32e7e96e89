#include "engine/render/sequence/sequence_observer.h"

#include <cmath>
#include <utility>

namespace campuswalk::engine::render {
namespace {

constexpr double kTolerance = 1e-9;  ///< tolerance, in units of `every`

}  // namespace

SequenceObserver::SequenceObserver(const scene::Campus& campus, SequenceSettings settings,
                                   RendererStore& renderers, std::vector<std::unique_ptr<FrameSink>> sinks,
                                   std::unique_ptr<FrameSource> remote_frames)
    : campus_(campus),
      settings_(std::move(settings)),
      renderers_(renderers),
      remote_frames_(std::move(remote_frames)),
      queue_(std::move(sinks), remote_frames_.get(), settings_.share.parts) {}

void SequenceObserver::begin(const Walk& walk) {
    requests_.begin(walk);
}

void SequenceObserver::on_tick(const TickRecord& record) {
    requests_.follow(record.avatar);
    if (!is_due(record.time)) {
        return;
    }
    const std::size_t number = taken_++;
    if (settings_.share.has(number)) {
        SnapshotRenderer& renderer = renderers_.of(campus_, requests_.light());
        queue_.add({renderer.draw(requests_.request(record, settings_.camera)), number, record.time});
    } else if (remote_frames_) {
        queue_.add_remote(number);
    }
}

void SequenceObserver::end() {
    queue_.finish();
}

bool SequenceObserver::is_due(double time) {
    const double now = time / settings_.every + kTolerance;
    if (now < next_) {
        return false;
    }
    next_ = std::floor(now) + 1.0;
    return true;
}

}  // namespace campuswalk::engine::render
