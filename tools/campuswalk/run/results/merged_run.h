#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/report/run_plan.h"
#include "tools/campuswalk/run/results/result_file.h"

namespace campuswalk::tools {

/// The reports of a run's shards, put together again, and what is missing to the run. Its memory depends on
/// the number of reports, not on that of results.
class MergedRun {
public:
    /// Takes the first file's run for the one to merge. At least one file. Reads each of them through; throws
    /// what ResultFile::for_each throws.
    explicit MergedRun(const std::vector<ResultFile>& files);
    /// Merges this run, whatever there is of it. `subject` is what problems of the whole run are about.
    MergedRun(engine::RunPlan run, std::filesystem::path subject, const std::vector<ResultFile>& files);

    /// Why the reports don't prove that every planned case was evaluated.
    const std::vector<std::string>& problems() const { return problems_; }
    /// As a run in one shard would have had it.
    engine::RunPlan plan() const;
    /// In the order in which a single run would have reported them.
    void for_each(const ResultVisitor& visit) const;

    /// What there is of a shard.
    struct ShardState {
        bool whole = false;  ///< it has a report with all its results
        int exit_code = 0;   ///< that its run should have had
    };
    /// Of those with a report, by their numbers from 1 on.
    const std::map<int, ShardState>& states() const { return states_; }

private:
    void note(const std::filesystem::path& subject, scene::DiagnosticCode code, const std::string& message);
    void add(const ResultFile& file);
    void note_missing_shards();
    /// Compares each shard's cases with those that the plan gives it.
    void check_cases();

    engine::RunPlan run_;
    std::filesystem::path run_file_;    ///< what problems of the whole run are about
    std::filesystem::path first_file_;  ///< of the first shard that belongs to the run
    std::string division_;              ///< of all cases in one shard
    std::map<int, ResultFile> shards_;
    std::map<int, ShardState> states_;
    std::vector<std::string> problems_;
};

}  // namespace campuswalk::tools
