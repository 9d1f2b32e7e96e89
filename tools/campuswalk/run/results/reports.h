#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/make_reporter.h"
#include "engine/report/reporter.h"
#include "tools/campuswalk/base/log_output.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Throws scene::InputError when a report can't be written where it is to go, or two go to one place. Touches
/// nothing.
void check_targets(const std::vector<ReportTarget>& reports);

/// Everything that is said about a run, each report where it goes. What can't be written is thrown as
/// std::runtime_error.
class Reports {
public:
    /// Opens files that are asked for, with the folders they need; what was in them is gone. `with_logs`
    /// leaves "log" out when false.
    Reports(const std::vector<ReportTarget>& targets, const engine::ReportStyle& style, bool with_logs);

    bool wants_log() const { return !logs_.empty(); }
    /// Whether standard output tells how the walks ended.
    bool prints_outcomes() const { return prints_outcomes_; }

    void begin(std::size_t cases);
    void log(std::string_view lines);
    void result(const engine::WalkResult& result);
    void end(const engine::RunReport& report);

private:
    std::vector<std::unique_ptr<LogOutput>> outputs_;
    std::vector<LogOutput*> logs_;
    std::vector<std::unique_ptr<engine::Reporter>> reporters_;
    bool prints_outcomes_ = false;
};

}  // namespace campuswalk::tools
