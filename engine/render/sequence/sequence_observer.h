#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/record/observer.h"
#include "engine/render/sequence/frame_queue.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/render/snapshot/walk_shots.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Draws what is to be seen at even times of a walk.
struct SequenceSettings {
    double every = 0.5;     ///< simulated seconds; no more than a frame a tick
    CameraSettings camera;  ///< what each is taken with
    FrameShare share;       ///< which of them
};

/// Takes the first frame at a walk's first tick, and the others as their times come.
class SequenceObserver final : public Observer {
public:
    /// `others` draw what isn't in the share; without them the sinks get the share alone. `campus` and
    /// `painters` must outlive it.
    SequenceObserver(const scene::Campus& campus, SequenceSettings settings, RendererStore& renderers,
                     std::vector<std::unique_ptr<FrameSink>> sinks,
                     std::unique_ptr<FrameSource> others = nullptr);

    void begin(const Walk& walk) override;
    /// Throws RenderError when the machine can't draw, and what a sink or the others threw at a frame before.
    void frame(const TickRecord& record) override;
    void end() override;

private:
    bool is_due(double time);

    const scene::Campus& campus_;
    SequenceSettings settings_;
    RendererStore& renderers_;
    SnapshotRequestBuilder requests_;
    std::unique_ptr<FrameSource> others_;
    std::size_t taken_ = 0;  ///< by whomever
    double next_ = 0.0;      ///< times of `every`
    FrameQueue queue_;
};

}  // namespace campuswalk::engine::render
