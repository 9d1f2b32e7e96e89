#include "tools/campuswalk/run/plan/plan.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "config/loader/load_run.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/plan/balance.h"
#include "tools/campuswalk/run/plan/case_times.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/plan_hash.h"
#include "tools/campuswalk/run/plan/reference_files.h"
#include "tools/campuswalk/run/plan/strict_rules.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using config::ProjectConfig;
using engine::Outcome;
using engine::WalkResult;
using engine::WalkStatus;
using scene::InputError;

namespace {

/// A walk in a project, as far as it could be read.
struct Candidate {
    WalkResult result;
    std::string folder;
    std::optional<config::Run> run;  ///< nullopt if it has errors
};

/// What a candidate is read from, kept for those of other shards as well.
struct Sources {
    fs::path walk;
    std::string project;
    fs::path campus_file;
    std::shared_ptr<const scene::CampusDescription> campus;  ///< null if the walk isn't played
};

class Planner {
public:
    Planner(const RunSettings& settings, PlanOptions options)
        : settings_(settings), options_(std::move(options)) {}

    Plan plan() {
        Plan plan;
        for (const ProjectConfig& project : settings_.projects) {
            selectors_.push_back(selector_of(project));
        }
        read_all(plan);
        plan.left_out = keep_only_marked();
        if (options_.ids) {
            std::erase_if(candidates_,
                          [&](const Candidate& candidate) { return !has_selected_id(candidate); });
        }
        divide();
        plan.summary = summarized();
        count_walks(plan);
        if (options_.summary_only) {
            return plan;
        }
        const std::vector<Sources> sources = sources_of_candidates();
        plan.other_folders = keep_shard();
        for (Candidate& candidate : candidates_) {
            add_cases(candidate, plan.cases);
        }
        plan.inputs = inputs_of(sources);  // of campuses that are built by now, nothing is looked up again
        plan.summary.cases = plan.cases.size();
        return plan;
    }

private:
    /// Links, copies and projects don't make more of a walk.
    void count_walks(Plan& plan) {
        std::set<std::string> files;
        std::set<std::string> walks;
        FileHashes hashes;
        for (const Candidate& candidate : candidates_) {
            const std::string& file = candidate.result.file;
            std::error_code ignored;
            if (files.insert(file).second) {
                walks.insert(settings_.strict ? to_string(hashes.of(file))
                                              : fs::weakly_canonical(file, ignored).string());
            }
        }
        plan.walks = walks.size();
        plan.same_walks = files.size() - walks.size();
    }

    void read_all(Plan& plan) {
        const std::vector<fs::path> files = find_walks(settings_.paths);
        const std::vector<std::string> names = output_names(files);
        plan.files = files.size();
        for (std::size_t i = 0; i < files.size(); ++i) {
            for (std::size_t j = 0; j < settings_.projects.size(); ++j) {
                Candidate candidate = read(files[i], names[i], settings_.projects[j]);
                if (is_selected(candidate, options_.selector) && is_selected(candidate, selectors_[j])) {
                    candidates_.push_back(std::move(candidate));
                }
            }
        }
    }

    Candidate read(const fs::path& file, const std::string& folder, const ProjectConfig& project) {
        Candidate candidate;
        WalkResult& result = candidate.result;
        result.file = file.generic_string();
        result.name = without_ending(file.filename().generic_string(), config::kWalkSuffix);
        result.project = project.name;
        result.config = project.name.empty() ? "" : settings_.config.generic_string();
        result.id = result.file + (project.name.empty() ? "" : " " + project.name);
        candidate.folder = folder + (project.name.empty() ? "" : "/" + project.name);
        try {
            config::Run run = loader_.read(file, project.overrides);
            refuse(reference_errors(file));
            apply_settings(run.walk, project);
            if (settings_.strict) {
                refuse(strict_errors(run.walk, settings_.tolerance));
            }
            describe(run.walk, result);
            candidate.run = std::move(run);
        } catch (const InputError& error) {
            note_errors(result, error);
        }
        return candidate;
    }

    void apply_settings(engine::Walk& walk, const ProjectConfig& project) const {
        walk.project = project.name;
        walk.sim.tree = options_.tree.value_or(walk.sim.tree);
        if (!walk.timeout) {
            walk.timeout = project.timeout ? project.timeout : settings_.timeout;
        }
        if (options_.max_timeout) {
            walk.timeout = std::min(walk.timeout.value_or(*options_.max_timeout), *options_.max_timeout);
        }
    }

    /// A walk may do without textures, unless its images are evaluated.
    std::vector<scene::Diagnostic> texture_errors(const LoadedWalk& loaded) const {
        const bool evaluates_images =
            options_.images && std::ranges::any_of(loaded.walk.expectations, engine::is_about_images);
        if (!settings_.strict && !evaluates_images) {
            return {};
        }
        std::vector<scene::Diagnostic> errors = loaded.campus->texture_warnings;
        for (scene::Diagnostic& error : errors) {
            error.severity = scene::Severity::error;
        }
        return errors;
    }

    static void refuse(std::vector<scene::Diagnostic> errors) {
        if (!errors.empty()) {
            throw InputError(std::move(errors));
        }
    }

    static void describe(const engine::Walk& walk, WalkResult& result) {
        result.tags = walk.tags;
        result.status_reason = walk.status.reason;
        result.expected_to_fail = walk.status.kind == WalkStatus::Kind::xfail;
        result.campus = walk.campus_name;
        result.ticks_per_second = walk.sim.ticks_per_second;
        result.timeout = walk.timeout;
        if (walk.status.kind == WalkStatus::Kind::skip) {
            result.outcome = Outcome::skipped;
        }
    }

    static void note_errors(WalkResult& result, const InputError& error) {
        result.outcome = Outcome::bad_input;
        result.diagnostics.insert(result.diagnostics.end(), error.diagnostics().begin(),
                                  error.diagnostics().end());
    }

    static bool is_selected(const Candidate& candidate, const Selector& selector) {
        const WalkResult& result = candidate.result;
        return candidate.run ? selector.takes(result.file, result.name, result.tags)
                             : selector.may_take(result.file, result.name);
    }

    static bool is_only(const Candidate& candidate) {
        return candidate.run && candidate.run->walk.status.kind == WalkStatus::Kind::only;
    }

    /// Returns how many walks it removes. A walk that can't be read might be marked `only`, so it stays.
    std::size_t keep_only_marked() {
        const auto first = std::ranges::find_if(candidates_, is_only);
        if (first == candidates_.end()) {
            return 0;
        }
        if (settings_.forbid_only) {
            throw InputError(first->run->walk.status.mark, "only-forbidden",
                             "'status: only' keeps the other walks from being run, which --forbid-only and "
                             "CI don't allow; "
                             "remove it");
        }
        return std::erase_if(candidates_, [](const Candidate& candidate) {
            return candidate.run.has_value() && !is_only(candidate);
        });
    }

    std::string id_of(const Candidate& candidate, int repetition) const {
        return candidate.result.id +
               (options_.repeat_each > 1 ? " #" + std::to_string(repetition + 1) : std::string());
    }

    bool has_selected_id(const Candidate& candidate) const {
        for (int repetition = 0; repetition < options_.repeat_each; ++repetition) {
            if (options_.ids->contains(id_of(candidate, repetition))) {
                return true;
            }
        }
        return false;
    }

    /// Repetitions stay together, so that they can be compared.
    void divide() {
        CaseTimes known;
        if (settings_.shard_times) {
            add_case_times(*settings_.shard_times, known);
        }
        std::vector<std::optional<std::uint64_t>> times;
        for (const Candidate& candidate : candidates_) {
            std::optional<std::uint64_t>& time = times.emplace_back();
            for (int repetition = 0; repetition < options_.repeat_each; ++repetition) {
                const auto found = known.find(id_of(candidate, repetition));
                time = found == known.end() ? time : time.value_or(0) + found->second;
            }
        }
        shard_of_ = balanced(times, settings_.shard.value_or(Shard()).count);
    }

    /// Of all shards.
    engine::RunPlan summarized() const {
        const Shard shard = settings_.shard.value_or(Shard());
        engine::RunPlan plan;
        plan.shard = shard.index + 1;
        plan.shards = shard.count;
        PlanContents contents;
        for (const Candidate& candidate : candidates_) {
            contents.add(candidate.result, candidate.run ? &*candidate.run : nullptr);
        }
        std::vector<std::size_t> by_shard(candidates_.size());
        std::iota(by_shard.begin(), by_shard.end(), std::size_t{0});
        std::ranges::stable_sort(by_shard, {}, [&](std::size_t i) { return shard_of_[i]; });
        Division division;
        for (const std::size_t i : by_shard) {
            for (int repetition = 0; repetition < options_.repeat_each; ++repetition) {
                division.add(shard_of_[i] + 1, id_of(candidates_[i], repetition));
                ++plan.all_cases;
            }
        }
        plan.contents = contents.hash();
        plan.division = division.hash();
        return plan;
    }

    std::vector<Sources> sources_of_candidates() const {
        std::vector<Sources> sources;
        for (const Candidate& candidate : candidates_) {
            Sources& each = sources.emplace_back();
            each.walk = candidate.result.file;
            each.project = candidate.result.project;
            if (candidate.run && candidate.result.outcome != Outcome::skipped) {
                each.campus_file = candidate.run->walk.campus;
                each.campus = candidate.run->campus;
            }
        }
        return sources;
    }

    std::vector<Inputs> inputs_of(const std::vector<Sources>& sources) {
        std::vector<Inputs> inputs;
        std::set<const scene::CampusDescription*> listed;
        std::set<fs::path> folders;
        for (const Sources& each : sources) {
            if (each.campus && listed.insert(each.campus.get()).second) {
                inputs.push_back({each.campus_file.lexically_normal().generic_string(),
                                  loader_.files_of(each.campus_file, *each.campus)});
            }
            const fs::path goldens = golden_log_file(each.walk, each.project).parent_path();
            if (folders.insert(goldens).second) {
                inputs.push_back({each.walk.generic_string(), reference_files(goldens)});
            }
        }
        return inputs;
    }

    /// Returns the folders of the others.
    std::vector<std::string> keep_shard() {
        std::vector<Candidate> own;
        std::vector<std::string> others;
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            if (shard_of_[i] == settings_.shard.value_or(Shard()).index) {
                own.push_back(std::move(candidates_[i]));
            } else {
                others.push_back(candidates_[i].folder);
            }
        }
        candidates_ = std::move(own);
        return others;
    }

    void add_cases(Candidate& candidate, std::vector<Case>& cases) {
        std::shared_ptr<const LoadedWalk> walk;
        if (candidate.run && candidate.result.outcome != Outcome::skipped) {
            try {
                LoadedWalk loaded = loader_.ready(std::move(*candidate.run));
                refuse(texture_errors(loaded));
                if (settings_.strict) {
                    refuse(strict_errors(*loaded.campus, loaded.walk));
                }
                walk = std::make_shared<LoadedWalk>(std::move(loaded));
            } catch (const InputError& error) {
                note_errors(candidate.result, error);
            }
        }
        diagnose_once(candidate.result.diagnostics);
        for (int repetition = 0; repetition < options_.repeat_each; ++repetition) {
            Case& each = cases.emplace_back(Case{candidate.result, walk, candidate.folder});
            each.result.repetition = repetition;
            each.result.id = id_of(candidate, repetition);
            if (options_.repeat_each > 1) {
                each.folder += "/repeat-" + std::to_string(repetition + 1);
            }
        }
    }

    /// Many walks may share a campus that has errors.
    void diagnose_once(const std::vector<scene::Diagnostic>& diagnostics) {
        for (const scene::Diagnostic& diagnostic : diagnostics) {
            const std::string line = to_string(diagnostic);
            if (reported_.insert(line).second) {
                print_error_line(line);
            }
        }
    }

    const RunSettings& settings_;
    PlanOptions options_;
    std::vector<Selector> selectors_;  ///< of each project
    WalkLoader loader_;
    std::vector<Candidate> candidates_;
    std::vector<int> shard_of_;  ///< of each candidate, before those of other shards are left out
    std::set<std::string> reported_;
};

/// What --list prints of a case besides its name and tags.
std::string remark(const WalkResult& result) {
    const std::string reason = result.status_reason.empty() ? "" : ": " + result.status_reason;
    if (result.outcome == Outcome::bad_input) {
        return " (has errors)";
    }
    if (result.outcome == Outcome::skipped) {
        return " (skip" + reason + ")";
    }
    return result.expected_to_fail ? " (xfail" + reason + ")" : "";
}

}  // namespace

Selector selector_of(const ProjectConfig& project) {
    Selector selector;
    if (project.grep) {
        selector.require(project.grep->text, project.grep->mark);
    }
    if (project.grep_invert) {
        selector.refuse(project.grep_invert->text, project.grep_invert->mark);
    }
    selector.require_tag(project.tags);
    return selector;
}

PlanOptions plan_options(const RunOptions& options) {
    PlanOptions plan;
    if (options.grep) {
        plan.selector.require(*options.grep, {"--grep", 0, 0});
    }
    if (options.grep_invert) {
        plan.selector.refuse(*options.grep_invert, {"--grep-invert", 0, 0});
    }
    plan.selector.require_tag(options.tags);
    plan.repeat_each = options.repeat_each;
    plan.tree = options.tree;
    plan.max_timeout = options.timeout;
    return plan;
}

void require_walks(const Plan& plan, int at_least) {
    if (plan.walks >= static_cast<std::size_t>(at_least)) {
        return;
    }
    throw error_about("--min-cases", "too-few-cases",
                      "only " + std::to_string(plan.walks) + " of at least " +
                          scene::plural(static_cast<std::size_t>(at_least), "walk") + " would be run" +
                          (plan.same_walks == 0 ? ""
                                                : ", as " + scene::plural(plan.same_walks, "file") +
                                                      " more have the same contents as one of them") +
                          "; see --list");
}

Plan make_plan(const RunSettings& settings, PlanOptions options) {
    return Planner(settings, std::move(options)).plan();
}

void print_cases(const Plan& plan) {
    for (const Case& each : plan.cases) {
        std::string line = each.result.id;
        for (const std::string& tag : each.result.tags) {
            line += " @" + tag;
        }
        print_line("%s%s", line.c_str(), remark(each.result).c_str());
    }
}

}  // namespace campuswalk::tools
