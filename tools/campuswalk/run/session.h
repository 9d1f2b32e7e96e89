#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campuswalk/base/log_output.h"
#include "tools/campuswalk/run/cases/play.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/results/last_run.h"
#include "tools/campuswalk/run/results/progress.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/workers/frame_helpers.h"
#include "tools/campuswalk/run/workers/worker_pool.h"

namespace campuswalk::tools {

/// How a plan is carried out.
struct SessionSettings {
    PlaySettings play;
    PoolSettings pool;
    std::optional<int> max_failures;
    bool require_identical = false;
    bool told_on_standard_error = false;  ///< how each walk ended
    bool progress = false;
    Backend backend = engine::render::RenderingBackend::automatic;  ///< of images
};

/// Plays a plan's cases and tells of them, in the plan's order.
class Session {
public:
    /// `events` and `last_run` may be null. Results in `earlier` are those of cases that have been played.
    Session(Plan plan, SessionSettings settings, Reports& reports, LogOutput* events,
            LastRunWriter* last_run);

    /// Takes the results of a run that was killed, by their ids.
    void take_over(const std::vector<engine::WalkResult>& earlier);

    /// Returns the exit code.
    int run();

private:
    std::vector<std::size_t> to_play() const;
    /// In a worker's process.
    engine::WalkResult play_case(std::size_t index, const Say& say);
    /// Null when this process is to draw all frames of the case.
    std::unique_ptr<FrameHelpers> frame_helpers_for(std::size_t index);
    void keep(std::size_t index, const Ending& ending);
    void hear(Topic topic, std::string_view lines);
    /// Those up to the case and those that need no playing after it; false when there have been enough
    /// failures.
    bool tell_up_to(std::size_t index);
    void tell(engine::WalkResult result);
    bool enough() const;
    engine::WalkResult result_of(std::size_t index, const Ending& ending) const;
    int finish(bool interrupted);

    Plan plan_;
    SessionSettings settings_;
    Reports& reports_;
    LogOutput* events_;
    LastRunWriter* last_run_;
    Progress progress_;
    std::size_t workers_ = 1;                                   ///< that there will be at most
    std::shared_ptr<engine::render::RendererStore> renderers_;  ///< of the process that plays; null for none
    bool may_fork_ = true;                                      ///< likewise: it has drawn nothing
    std::vector<bool> over_;                                    ///< of each case: its result is known
    std::size_t told_ = 0;
    int failures_ = 0;
    engine::WalkResult first_;  ///< repetition of the walk that is being told of
    engine::RunReport report_;
};

}  // namespace campuswalk::tools
