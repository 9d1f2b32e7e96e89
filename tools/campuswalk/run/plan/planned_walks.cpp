#include "tools/campuswalk/run/plan/planned_walks.h"

#include <algorithm>
#include <utility>

#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/reference_files.h"
#include "tools/campuswalk/run/plan/strict_rules.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using config::ProjectConfig;
using engine::WalkResult;
using engine::WalkStatus;
using scene::InputError;

namespace {

void apply_settings(const RunSettings& settings, const PlanOptions& options, const ProjectConfig& project,
                    engine::Walk& walk) {
    walk.project = project.name;
    walk.sim.tree = options.tree.value_or(walk.sim.tree);
    if (!walk.timeout) {
        walk.timeout = project.timeout ? project.timeout : settings.timeout;
    }
    if (options.max_timeout) {
        walk.timeout = std::min(walk.timeout.value_or(*options.max_timeout), *options.max_timeout);
    }
}

void describe(const engine::Walk& walk, WalkResult& result) {
    result.tags = walk.tags;
    result.status_reason = walk.status.reason;
    result.expected_to_fail = walk.status.kind == WalkStatus::Kind::xfail;
    result.campus = walk.campus_name;
    result.ticks_per_second = walk.sim.ticks_per_second;
    result.timeout = walk.timeout;
    if (walk.status.kind == WalkStatus::Kind::skip) {
        result.outcome = engine::Outcome::skipped;
    }
}

/// What is known of a walk in a project by its file alone.
WalkResult named_by(const fs::path& file, const RunSettings& settings, const ProjectConfig& project) {
    WalkResult result;
    result.file = file.generic_string();
    result.name = without_ending(file.filename().generic_string(), config::kWalkSuffix);
    result.project = project.name;
    result.config = project.name.empty() ? "" : settings.config.generic_string();
    result.id = result.file + (project.name.empty() ? "" : " " + project.name);
    return result;
}

bool is_selected(const PlannedWalk& walk, const Selector& selector) {
    const WalkResult& result = walk.result;
    return walk.run ? selector.takes(result.file, result.name, result.tags)
                    : selector.may_take(result.file, result.name);
}

bool is_only(const PlannedWalk& walk) {
    return walk.run && walk.run->walk.status.kind == WalkStatus::Kind::only;
}

/// Returns how many walks it removes. A walk that can't be read might be marked `only`, so it stays.
std::size_t keep_only_marked(std::vector<PlannedWalk>& walks, bool forbid_only) {
    const auto first = std::ranges::find_if(walks, is_only);
    if (first == walks.end()) {
        return 0;
    }
    if (forbid_only) {
        throw InputError(first->run->walk.status.mark, "only-forbidden",
                         "'status: only' keeps the other walks from being run, which --forbid-only and "
                         "CI don't allow; "
                         "remove it");
    }
    return std::erase_if(walks, [](const PlannedWalk& walk) { return walk.run && !is_only(walk); });
}

bool has_id(const PlannedWalk& walk, const std::set<std::string>& ids, int repeat_each) {
    for (int repetition = 0; repetition < repeat_each; ++repetition) {
        if (ids.contains(walk.id_of(repetition, repeat_each))) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::string PlannedWalk::id_of(int repetition, int repeat_each) const {
    return result.id + (repeat_each > 1 ? " #" + std::to_string(repetition + 1) : "");
}

SelectedWalks select_walks(const RunSettings& settings, const PlanOptions& options, WalkLoader& loader) {
    std::vector<Selector> selectors;
    for (const ProjectConfig& project : settings.projects) {
        selectors.push_back(selector_of(project));
    }
    const auto read = [&](const fs::path& file, const std::string& folder, const ProjectConfig& project) {
        PlannedWalk walk{.result = named_by(file, settings, project),
                         .folder = folder + (project.name.empty() ? "" : "/" + project.name),
                         .run = {}};
        try {
            config::Run run = loader.read(file, project.overrides);
            refuse(reference_errors(file));
            apply_settings(settings, options, project, run.walk);
            if (settings.strict) {
                refuse(strict_errors(run.walk, settings.tolerance));
            }
            describe(run.walk, walk.result);
            walk.run = std::move(run);
        } catch (const InputError& error) {
            note_errors(walk.result, error);
        }
        return walk;
    };
    const std::vector<fs::path> files = find_walks(settings.paths);
    const std::vector<std::string> names = output_names(files);
    SelectedWalks selected{.walks = {}, .files = files.size()};
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = 0; j < settings.projects.size(); ++j) {
            PlannedWalk walk = read(files[i], names[i], settings.projects[j]);
            if (is_selected(walk, options.selector) && is_selected(walk, selectors[j])) {
                selected.walks.push_back(std::move(walk));
            }
        }
    }
    selected.left_out = keep_only_marked(selected.walks, settings.forbid_only);
    if (options.ids) {
        std::erase_if(selected.walks, [&](const PlannedWalk& walk) {
            return !has_id(walk, *options.ids, options.repeat_each);
        });
    }
    return selected;
}

void refuse(std::vector<scene::Diagnostic> errors) {
    if (!errors.empty()) {
        throw InputError(std::move(errors));
    }
}

void note_errors(WalkResult& result, const InputError& error) {
    result.outcome = engine::Outcome::bad_input;
    result.diagnostics.insert(result.diagnostics.end(), error.diagnostics().begin(),
                              error.diagnostics().end());
}

}  // namespace campuswalk::tools
