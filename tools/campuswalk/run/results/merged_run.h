#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/report/run_plan.h"
#include "tools/campuswalk/run/results/result_file.h"

namespace campuswalk::tools {

/// The reports of a run's shards, put together again, and what is missing to the run.
class MergedRun {
public:
    /// At least one file. Reads each of them through; throws what ResultFile::for_each throws.
    explicit MergedRun(const std::vector<ResultFile>& files);

    /// Why the reports don't prove that every planned case was evaluated.
    const std::vector<std::string>& problems() const { return problems_; }
    /// As a run in one shard would have had it.
    engine::RunPlan plan() const;
    /// In the order in which a single run would have reported them.
    void for_each(const ResultVisitor& visit) const;

private:
    void note(const std::filesystem::path& subject, const char* code, const std::string& message);
    void add(const ResultFile& file);
    void note_missing_shards();
    /// Compares each shard's cases with those that the plan gives it.
    void check_cases();

    engine::RunPlan run_;
    std::filesystem::path run_file_;  ///< the first report
    std::string division_;            ///< of all cases in one shard
    std::map<int, ResultFile> shards_;
    std::vector<std::string> problems_;
};

}  // namespace campuswalk::tools
