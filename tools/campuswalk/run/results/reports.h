#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/make_reporter.h"
#include "engine/report/reporter.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/log_output.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// Throws scene::InputError when a report can't be written, or two go to the same file. Touches nothing.
void check_targets(const std::vector<ReportTarget>& reports);

/// All reports of a run. Throws std::runtime_error when one can't be written.
class Reports {
public:
    /// Opens the files, with the folders that they need. Older ones are replaced; files that make sense only
    /// as a whole (junit, json, html, markdown) are removed by begin(), written beside their place and
    /// renamed at the end, so that what is there is neither half a report nor another run's. Leaves "log" out
    /// unless `with_logs`. With a key, the lines of jsonl reports are signed with it.
    Reports(const std::vector<ReportTarget>& targets, const engine::ReportStyle& style, bool with_logs,
            const std::optional<std::string>& key = {});

    bool has_log() const { return !logs_.empty(); }
    /// Whether a report on standard output says how the walks ended.
    bool prints_outcomes() const { return prints_outcomes_; }

    void begin(const engine::RunPlan& plan);
    void log(std::string_view lines);
    void result(const engine::WalkResult& result);
    void end(const engine::ResultSequence& results);

private:
    engine::TextSink sink_for(const ReportTarget& target, const std::optional<std::string>& key);

    std::vector<std::unique_ptr<LogOutput>> outputs_;
    std::vector<std::filesystem::path> outdated_;  ///< the places of whole files
    std::vector<std::unique_ptr<scene::AtomicFile>> whole_files_;
    std::vector<LogOutput*> logs_;
    std::vector<std::unique_ptr<engine::Reporter>> reporters_;
    bool prints_outcomes_ = false;
};

}  // namespace campuswalk::tools
