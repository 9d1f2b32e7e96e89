#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tools/campuswalk/base/log_output.h"
#include "tools/campuswalk/run/cases/case_runner.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/results/last_run.h"
#include "tools/campuswalk/run/results/progress.h"
#include "tools/campuswalk/run/results/reports.h"
#include "tools/campuswalk/run/workers/worker_pool.h"

namespace campuswalk::tools {

/// How to run a plan.
struct SchedulerSettings {
    PlaySettings play;  ///< the scheduler sets how many processes draw
    PoolSettings pool;
    std::optional<int> max_failures;
    bool require_identical = false;
    bool print_verdicts = false;  ///< of each walk on standard error
    bool progress = false;
};

/// The parent process of a run: lets workers play a plan's cases and reports their results in the plan's
/// order.
class Scheduler {
public:
    /// `events` and `last_run` may be null.
    Scheduler(Plan plan, SchedulerSettings settings, Reports& reports, LogOutput* events,
              LastRunWriter* last_run);

    /// Uses the results of a run that was killed, by their ids, instead of playing those cases.
    void take_over(const std::vector<engine::WalkResult>& earlier);

    /// Returns the exit code.
    int run();

private:
    std::vector<std::size_t> to_play() const;
    PoolListener listener();
    void save(std::size_t index, const Ending& ending);
    void handle_message(std::size_t index, Topic topic, std::string_view body);
    /// Reports the cases up to `index` and those after it that are over; false when there have been enough
    /// failures.
    bool report_up_to(std::size_t index);
    void report(engine::WalkResult result);
    bool has_enough_failures() const;
    engine::WalkResult result_of(std::size_t index, const Ending& ending) const;
    int finish(bool interrupted);

    Plan plan_;
    SchedulerSettings settings_;
    Reports& reports_;
    LogOutput* events_;
    LastRunWriter* last_run_;
    Progress progress_;
    std::vector<bool> over_;    ///< for each case, whether its result is known
    std::size_t reported_ = 0;  ///< cases
    int failures_ = 0;
    engine::WalkResult first_;  ///< repetition of the walk that is reported now
    engine::RunReport report_;
};

}  // namespace campuswalk::tools
