#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/record/observer.h"
#include "engine/render/sequence/frame_queue.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/render/snapshot/walk_snapshots.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// When and how frames of a walk are drawn.
struct SequenceSettings {
    double every = 0.5;     ///< simulated seconds between frames; at most one per tick
    CameraSettings camera;  ///< of all frames
    SequenceShare share;    ///< the frames to draw in this process
};

/// Draws frames of a walk at regular times, the first at the first tick.
class SequenceObserver final : public Observer {
public:
    /// `remote_frames` supplies the frames outside of the share; if null, sinks get the share only. `campus`
    /// and `renderers` must outlive this.
    SequenceObserver(const scene::Campus& campus, SequenceSettings settings, RendererStore& renderers,
                     std::vector<std::unique_ptr<FrameSink>> sinks,
                     std::unique_ptr<FrameSource> remote_frames = nullptr);

    void begin(const Walk& walk) override;
    /// Throws RenderError if rendering is impossible; rethrows what a sink or the source threw at an earlier
    /// frame.
    void on_tick(const TickRecord& record) override;
    void end() override;

private:
    bool is_due(double time);

    const scene::Campus& campus_;
    SequenceSettings settings_;
    RendererStore& renderers_;
    SnapshotRequestBuilder requests_;
    std::unique_ptr<FrameSource> remote_frames_;
    std::size_t taken_ = 0;  ///< by all processes
    double next_ = 0.0;      ///< time of the next frame, in units of `every`
    FrameQueue queue_;
};

}  // namespace campuswalk::engine::render
