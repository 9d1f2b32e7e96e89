#include "tools/campuswalk/run/results/merged_run.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "scene/base/diagnostic.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/run/plan/plan_hash.h"
#include "tools/campuswalk/run/results/verdict.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
using engine::RunPlan;
using engine::WalkResult;

namespace {

constexpr std::size_t kBytesOfAllBlocks = std::size_t{32} << 20U;
constexpr std::size_t kLeastBlock = std::size_t{4} << 10U;
constexpr std::size_t kMostBlock = std::size_t{256} << 10U;

/// The next result of a file, and how to get to the one after it.
struct Source {
    ResultBlocks blocks;
    WalkResult next;
};

/// Whether `a` comes before `b` in a run.
bool comes_before(const WalkResult& a, const WalkResult& b) {
    return std::tie(a.file, a.project, a.repetition) < std::tie(b.file, b.project, b.repetition);
}

/// Calls `visit` for the results of all files in the order in which a single run would have reported them: by
/// file, project and repetition. Each file's own results must be in that order. Of each file only a block is
/// in memory, and it is open only while that is read: there may be more files than a process may open.
/// Throws what ResultFile::for_each throws.
void for_each_merged(const std::vector<const ResultFile*>& files, const ResultVisitor& visit) {
    const std::size_t block =
        std::clamp(kBytesOfAllBlocks / std::max<std::size_t>(1, files.size()), kLeastBlock, kMostBlock);
    std::vector<Source> sources;
    sources.reserve(files.size());
    const auto later = [&](std::size_t a, std::size_t b) {
        const bool earlier = comes_before(sources[a].next, sources[b].next);
        return !earlier && (comes_before(sources[b].next, sources[a].next) || b < a);
    };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> waiting(later);
    for (const ResultFile* file : files) {
        Source source{ResultBlocks(*file, block), {}};
        if (std::optional<WalkResult> first = source.blocks.next()) {
            source.next = std::move(*first);
            sources.push_back(std::move(source));
            waiting.push(sources.size() - 1);
        }
    }
    while (!waiting.empty()) {
        const std::size_t index = waiting.top();
        waiting.pop();
        Source& source = sources[index];
        WalkResult result = std::move(source.next);
        if (std::optional<WalkResult> after = source.blocks.next()) {
            source.next = std::move(*after);
            waiting.push(index);
        }
        visit(std::move(result));
    }
}

/// How a shard's fingerprint differs from another's; empty if it doesn't.
std::string other_part(const engine::RunFingerprint& shard, const engine::RunFingerprint& other) {
    if (shard.program != other.program) {
        return "by another version of campuswalk";
    }
    if (shard.options != other.options) {
        return "with other options, such as --strict,";
    }
    return shard.files == other.files ? ""
                                      : "on other files (models, textures, lists of places or golden files)";
}

}  // namespace

MergedRun::MergedRun(const std::vector<ResultFile>& files)
    : MergedRun(files.front().plan(), files.front().file(), files) {}

MergedRun::MergedRun(RunPlan run, fs::path subject, const std::vector<ResultFile>& files)
    : run_(std::move(run)), run_file_(std::move(subject)) {
    for (const ResultFile& file : files) {
        add(file);
    }
    note_missing_shards();
    check_cases();
}

RunPlan MergedRun::plan() const {
    RunPlan plan = run_;
    plan.cases = run_.all_cases;
    plan.shard = 1;
    plan.shards = 1;
    plan.division = division_;
    return plan;
}

void MergedRun::for_each(const ResultVisitor& visit) const {
    std::vector<const ResultFile*> files;
    files.reserve(shards_.size());
    for (const auto& [shard, file] : shards_) {
        files.push_back(&file);
    }
    for_each_merged(files, visit);
}

void MergedRun::note(const fs::path& subject, scene::DiagnosticCode code, const std::string& message) {
    problems_.push_back(
        scene::to_string({scene::Severity::error, {subject.generic_string(), 0, 0}, code, message}));
}

void MergedRun::add(const ResultFile& file) {
    const RunPlan& plan = file.plan();
    if (run_.fingerprint == engine::RunFingerprint()) {  // a job's plan is made before any file is read
        run_.fingerprint = plan.fingerprint;
    }
    const bool same_run = plan.shards == run_.shards && plan.all_cases == run_.all_cases &&
                          plan.contents == run_.contents && plan.division == run_.division &&
                          plan.start == run_.start;
    if (!same_run || plan.shard < 1 || plan.shard > plan.shards) {
        note(file.file(), "other-plan",
             "this report is of a run of other walks or in other shards; merge those of one run");
        return;
    }
    if (const std::string other = other_part(plan.fingerprint, run_.fingerprint); !other.empty()) {
        note(file.file(), "other-run",
             "this shard was run " + other + " than " + first_file_.generic_string() +
                 "; run all shards from one commit, with the same options");
        return;
    }
    first_file_ = first_file_.empty() ? file.file() : first_file_;
    const auto [there, is_new] = shards_.try_emplace(plan.shard, file);
    if (!is_new) {
        note(file.file(), "duplicate-shard",
             there->second.file().generic_string() + " is a report of shard " + std::to_string(plan.shard) +
                 ", too");
    }
}

void MergedRun::note_missing_shards() {
    constexpr std::size_t kListed = 10;
    std::vector<std::string> missing;
    for (int shard = 1; shard <= run_.shards && missing.size() < kListed; ++shard) {
        if (!shards_.contains(shard)) {
            missing.push_back(std::to_string(shard));
        }
    }
    const std::size_t count = static_cast<std::size_t>(std::max(run_.shards, 0)) - shards_.size();
    if (!missing.empty()) {
        note(run_file_, "missing-shard",
             "the run has " + std::to_string(run_.shards) + " shards, and there is no report of " +
                 joined(missing, ", ") + (count > missing.size() ? ", …" : ""));
    }
}

void MergedRun::check_cases() {
    Division divided;
    Division whole;
    std::size_t cases = 0;
    bool consecutive = true;  // as in runs that no times are known of
    WalkResult last;
    for (const auto& [shard, file] : shards_) {
        std::set<engine::Outcome> outcomes;
        std::size_t not_evaluated = 0;
        const std::size_t results = file.for_each([&, shard = shard](WalkResult&& result) {
            not_evaluated += result.not_evaluated > 0 ? 1U : 0U;
            divided.add(shard, result.id);
            whole.add(1, result.id);
            outcomes.insert(result.outcome);
            consecutive = consecutive && (last.id.empty() || comes_before(last, result));
            last = std::move(result);
        });
        cases += results;
        const std::size_t planned = file.plan().cases;
        states_[shard] = {results == planned, exit_code_of(outcomes)};
        if (not_evaluated > 0) {
            note(file.file(), "unevaluated-walks",
                 "expectations of " + scene::plural(not_evaluated, "walk") +
                     " about pictures weren't evaluated; run shard " + std::to_string(shard) +
                     " where pictures are drawn");
        }
        if (results != planned) {
            note(file.file(), "incomplete-report",
                 "it has " + std::to_string(results) + " of " + scene::plural(planned, "result") +
                     "; run shard " + std::to_string(shard) + " again");
        }
    }
    if (!consecutive) {
        whole = Division();
        for_each([&](WalkResult&& result) { whole.add(1, result.id); });
    }
    division_ = whole.hash();
    if (problems_.empty() && (divided.hash() != run_.division || cases != run_.all_cases)) {
        note(run_file_, "other-plan", "the reports' cases aren't those that the run had planned");
    }
}

}  // namespace campuswalk::tools
