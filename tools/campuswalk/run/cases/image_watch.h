#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/expect/failure.h"
#include "engine/observers/snapshot_states.h"
#include "engine/record/observer.h"
#include "engine/report/walk_result.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/run/cases/case_runner.h"
#include "tools/campuswalk/run/plan/plan.h"

namespace campuswalk::tools {

/// Without images nobody can tell whether such a walk fails as it says it must.
bool must_fail_in_images(const engine::Walk& walk);

/// The images of a walk that is played: they are taken, then judged, then told of.
class ImageWatch final : public engine::Observer {
public:
    /// All must outlive it; `helpers` may be null.
    ImageWatch(const Case& played, const PlaySettings& settings, engine::render::RendererStore& renderers,
               FrameHelpers* helpers);

    void frame(const engine::TickRecord& record) override;
    /// This and what it needs, alive as long as this.
    std::vector<engine::Observer*> observers();

    /// When the walk has ended: appends what its expectations of images found, says on standard error what
    /// was written to be kept, and gives the images that show what differs.
    std::vector<engine::Artifact> evaluator(std::vector<engine::Failure>& failures) const;

    /// The snapshots that the walk took, in order.
    std::vector<engine::Artifact> snapshot_files() const;

    /// What was made of the walk's frames; not each of them, which can be thousands.
    std::vector<engine::Artifact> sequence_files() const;

private:
    const Case& played_;
    const PlaySettings& settings_;
    std::vector<const engine::SnapshotStep*> taken_;
    SnapshotTaker taker_;
    std::unique_ptr<engine::Observer> sequence_;  ///< null when none is wished for
    engine::SnapshotStates moments_;
};

}  // namespace campuswalk::tools
