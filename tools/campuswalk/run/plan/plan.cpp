#include "tools/campuswalk/run/plan/plan.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "scene/lint/wording.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/plan/balance.h"
#include "tools/campuswalk/run/plan/case_times.h"
#include "tools/campuswalk/run/plan/plan_hash.h"
#include "tools/campuswalk/run/plan/planned_walks.h"
#include "tools/campuswalk/run/plan/reference_files.h"
#include "tools/campuswalk/run/plan/strict_rules.h"
#include "tools/campuswalk/suggest/frame_hints.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using engine::Outcome;
using engine::WalkResult;
using scene::InputError;

namespace {

/// Where a spawn is in the air, the campus may have another unit or upper axis.
constexpr scene::DiagnosticCode kSpawnInAir("spawn-in-air");

/// What a walk is read from, kept for those of other shards as well.
struct Sources {
    fs::path walk;
    std::string project;
    fs::path campus_file;
    std::shared_ptr<const scene::CampusDescription> campus;  ///< null if the walk isn't played
};

std::vector<Sources> sources_of(const std::vector<PlannedWalk>& walks) {
    std::vector<Sources> sources;
    for (const PlannedWalk& walk : walks) {
        Sources& each = sources.emplace_back(Sources{walk.result.file, walk.result.project, {}, {}});
        if (walk.is_playable()) {
            each.campus_file = walk.run->walk.campus;
            each.campus = walk.run->campus;
        }
    }
    return sources;
}

/// The shard of each walk, from 0. Repetitions stay together, so that they can be compared.
std::vector<int> divide(const RunSettings& settings, const std::vector<PlannedWalk>& walks, int repeat_each) {
    CaseTimes known;
    if (settings.shard_times) {
        add_case_times(*settings.shard_times, known);
    }
    std::vector<std::optional<std::uint64_t>> times;
    for (const PlannedWalk& walk : walks) {
        std::optional<std::uint64_t>& time = times.emplace_back();
        for (int repetition = 0; repetition < repeat_each; ++repetition) {
            const auto found = known.find(walk.id_of(repetition, repeat_each));
            time = found == known.end() ? time : time.value_or(0) + found->second;
        }
    }
    return balanced(times, settings.shard.value_or(Shard()).count);
}

/// The plan of all shards.
engine::RunPlan summarized(const Shard& shard, const std::vector<PlannedWalk>& walks,
                           const std::vector<int>& shard_of, int repeat_each) {
    engine::RunPlan plan;
    plan.shard = shard.index + 1;
    plan.shards = shard.count;
    PlanContents contents;
    for (const PlannedWalk& walk : walks) {
        contents.add(walk.result, walk.run ? &*walk.run : nullptr);
    }
    std::vector<std::size_t> by_shard(walks.size());
    std::iota(by_shard.begin(), by_shard.end(), std::size_t{0});
    std::ranges::stable_sort(by_shard, {}, [&](std::size_t i) { return shard_of[i]; });
    Division division;
    for (const std::size_t i : by_shard) {
        for (int repetition = 0; repetition < repeat_each; ++repetition) {
            division.add(shard_of[i] + 1, walks[i].id_of(repetition, repeat_each));
            ++plan.all_cases;
        }
    }
    plan.contents = contents.hash();
    plan.division = division.hash();
    return plan;
}

/// Sets how many walks there are. Links, copies and projects don't make more of a walk.
void count_walks(const std::vector<PlannedWalk>& walks, bool strict, Plan& plan) {
    std::set<std::string> files;
    std::set<std::string> different;
    FileHashes hashes;
    for (const PlannedWalk& walk : walks) {
        const std::string& file = walk.result.file;
        std::error_code ignored;
        if (files.insert(file).second) {
            different.insert(strict ? to_string(hashes.of(file))
                                    : fs::weakly_canonical(file, ignored).string());
        }
    }
    plan.walks = different.size();
    plan.same_walks = files.size() - different.size();
}

/// A walk may do without textures, unless its images are evaluated.
std::vector<scene::Diagnostic> texture_errors(const LoadedWalk& loaded, bool strict, bool images) {
    if (!strict && !(images && std::ranges::any_of(loaded.walk.expectations, engine::is_about_images))) {
        return {};
    }
    std::vector<scene::Diagnostic> errors = loaded.campus->texture_warnings;
    for (scene::Diagnostic& error : errors) {
        error.severity = scene::Severity::error;
    }
    return errors;
}

/// Makes the walk ready to be played. Null if it isn't to be, or if it has errors, which its result then has.
std::shared_ptr<const LoadedWalk> made_ready(PlannedWalk& walk, bool strict, bool images,
                                             WalkLoader& loader) {
    if (!walk.is_playable()) {
        return nullptr;
    }
    const fs::path campus_file = walk.run->walk.campus;
    try {
        LoadedWalk loaded = loader.ready(std::move(*walk.run));
        refuse(texture_errors(loaded, strict, images));
        if (strict) {
            refuse(strict_errors(*loaded.campus, loaded.walk));
        }
        return std::make_shared<LoadedWalk>(std::move(loaded));
    } catch (const InputError& error) {
        note_errors(walk.result, error);
        if (std::ranges::find(error.diagnostics(), kSpawnInAir, &scene::Diagnostic::code) !=
            error.diagnostics().end()) {
            std::ranges::move(frame_hints(*loader.load_campus(campus_file)),
                              std::back_inserter(walk.result.diagnostics));
        }
        return nullptr;
    }
}

/// Prints those that haven't been printed: many walks may share a campus that has errors.
void diagnose_once(const std::vector<scene::Diagnostic>& diagnostics, std::set<std::string>& printed) {
    for (const scene::Diagnostic& diagnostic : diagnostics) {
        const std::string line = to_string(diagnostic);
        if (printed.insert(line).second) {
            print_error_line(line);
        }
    }
}

void add_cases(const PlannedWalk& walk, const std::shared_ptr<const LoadedWalk>& loaded, int repeat_each,
               std::vector<Case>& cases) {
    for (int repetition = 0; repetition < repeat_each; ++repetition) {
        Case& each = cases.emplace_back(Case{walk.result, loaded, walk.folder});
        each.result.repetition = repetition;
        each.result.id = walk.id_of(repetition, repeat_each);
        if (repeat_each > 1) {
            each.folder += "/repeat-" + std::to_string(repetition + 1);
        }
    }
}

std::vector<Inputs> inputs_of(const std::vector<Sources>& sources, WalkLoader& loader) {
    std::vector<Inputs> inputs;
    std::set<const scene::CampusDescription*> listed;
    std::set<fs::path> folders;
    for (const Sources& each : sources) {
        if (each.campus && listed.insert(each.campus.get()).second) {
            inputs.push_back({each.campus_file.lexically_normal().generic_string(),
                              loader.files_of(each.campus_file, *each.campus)});
        }
        const fs::path goldens = golden_log_file(each.walk, each.project).parent_path();
        if (folders.insert(goldens).second) {
            inputs.push_back({each.walk.generic_string(), reference_files(goldens)});
        }
    }
    return inputs;
}

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

Plan make_plan(const RunSettings& settings, const PlanOptions& options) {
    WalkLoader loader;
    SelectedWalks selected = select_walks(settings, options, loader);
    std::vector<PlannedWalk>& walks = selected.walks;
    const Shard shard = settings.shard.value_or(Shard());
    const std::vector<int> shard_of = divide(settings, walks, options.repeat_each);
    Plan plan;
    plan.files = selected.files;
    plan.left_out = selected.left_out;
    plan.summary = summarized(shard, walks, shard_of, options.repeat_each);
    count_walks(walks, settings.strict, plan);
    if (options.summary_only) {
        return plan;
    }
    const std::vector<Sources> sources = sources_of(walks);
    std::set<std::string> printed;
    for (std::size_t i = 0; i < walks.size(); ++i) {
        if (shard_of[i] != shard.index) {
            plan.other_folders.push_back(walks[i].folder);
            continue;
        }
        const auto loaded = made_ready(walks[i], settings.strict, options.images, loader);
        diagnose_once(walks[i].result.diagnostics, printed);
        add_cases(walks[i], loaded, options.repeat_each, plan.cases);
    }
    plan.inputs =
        inputs_of(sources, loader);  // of campuses that are built by now, nothing is looked up again
    plan.summary.cases = plan.cases.size();
    return plan;
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
