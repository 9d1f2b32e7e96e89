#pragma once

#include <memory>
#include <vector>

#include "engine/observers/snapshot_states.h"
#include "engine/record/observer.h"
#include "engine/report/walk_result.h"
#include "tools/campuswalk/images/image_verdicts.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/run/cases/case_runner.h"
#include "tools/campuswalk/run/plan/plan.h"

namespace campuswalk::tools {

/// Whether only images can show if the walk fails as it is expected to.
bool must_fail_in_images(const engine::Walk& walk);

/// The images of a walk that is played: takes, evaluates and lists them.
class ImageWatch final : public engine::Observer {
public:
    /// All arguments must outlive it; `helpers` may be null.
    ImageWatch(const Case& played, const PlaySettings& settings, engine::render::RendererStore& renderers,
               FrameHelpers* helpers);

    void on_tick(const engine::TickRecord& record) override;
    /// This and the observers that it needs, which live as long as this.
    std::vector<engine::Observer*> observers();

    /// Evaluates the walk's image expectations; to be called when it has ended.
    EvaluatedImages evaluate() const;

    /// The snapshots that the walk took, in order.
    std::vector<engine::Artifact> snapshot_files() const;

    /// What was made of the walk's frames, but not the frames, of which there may be thousands.
    std::vector<engine::Artifact> sequence_files() const;

private:
    const Case& played_;
    const PlaySettings& settings_;
    std::vector<const engine::SnapshotStep*> taken_;
    SnapshotTaker taker_;
    std::unique_ptr<engine::Observer> sequence_;  ///< null if none is requested
    engine::SnapshotStates moments_;
};

}  // namespace campuswalk::tools
