#include "tools/campuswalk/suggest/suggestion_text.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "config/loader/search_paths.h"
#include "scene/lint/model_report.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/suggest/frame_text.h"
#include "tools/campuswalk/suggest/lint_text.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// The lints of the model that still hold for the campus.
struct RemainingLints {
    std::vector<scene::ModelLint> lints;
    std::size_t opened = 0;  ///< doors that the campus leaves out, so that they close nothing
};

RemainingLints remaining_lints(const UprightModel& model) {
    const std::vector<std::string> open = closed_door_names(model.report);
    RemainingLints left;
    for (const scene::ModelLint& lint : model.report.warnings) {
        if (lint.code != "solid-door") {
            left.lints.push_back(lint);
            continue;
        }
        std::vector<scene::ModelLint::Place> closed = lint.places;
        left.opened += std::erase_if(closed, [&](const scene::ModelLint::Place& place) {
            return std::ranges::find(open, place.node) != open.end();
        });
        if (!closed.empty()) {
            left.lints.push_back(scene::solid_doors(std::move(closed)));
        }
    }
    return left;
}

/// That walks on the campus must be allowed to read the file, if so.
void print_outside(const fs::path& campus_file, const fs::path& file, const char* what) {
    if (!config::read_roots(campus_file, search_paths()).why_unreadable(file).empty()) {
        print_line("%s isn't in the project: run the walk with --root %s", what,
                   file.parent_path().string().c_str());
    }
}

void print_walk(const Suggestion& suggestion) {
    const SuggestedCampus& campus = suggestion.campus;
    const std::size_t visits = suggestion.walk.visits;
    print_line("%s: %s, played%s%s", suggestion.walk_file.lexically_normal().string().c_str(),
               scene::plural(visits, "visit").c_str(),
               campus.ground ? ", on a box: the model has no ground" : "",
               enters_something(campus, visits) ? "" : "; it goes through no door");
    if (campus.starts_aside) {
        print_line("  it starts above rooms, perhaps on a roof: nothing else was found to stand on");
    }
    for (std::size_t i = 0; i < campus.more_spawns.size(); ++i) {
        print_line("  spawn %s, too: %.0f m² of ground that isn't reached from start",
                   more_spawn_name(i).c_str(), campus.more_spawns[i].area);
    }
    if (campus.most_triangles) {
        print_line("  to save time, %s", crowded_text(campus).c_str());
    }
    for (const SuggestedDoorway& doorway : campus.doorways) {
        print_line("  closing %s", closing_text(doorway).c_str());
    }
}

}  // namespace

void print_suggestion(const Suggestion& suggestion) {
    const SuggestedCampus& campus = suggestion.campus;
    print_line("%s: %s%s", suggestion.campus_file.lexically_normal().string().c_str(),
               scene::plural(campus.buildings.size(), "building").c_str(),
               campus.more_buildings == 0 ? ""
                                          : (", and " + std::to_string(campus.more_buildings) +
                                             " smaller ones without names left out")
                                                .c_str());
    print_walk(suggestion);
    print_outside(suggestion.campus_file, suggestion.model.file.path, "the model");
    if (campus.places) {
        print_outside(suggestion.campus_file, suggestion.campus_file.parent_path() / campus.places->path,
                      "the file of places");
    }
    for (const std::string& line : frame_lines(suggestion.model)) {
        print_line("%s", line.c_str());
    }
    const RemainingLints left = remaining_lints(suggestion.model);
    if (left.opened > 0) {
        print_line("%s left out of what is solid", scene::plural(left.opened, "closed door").c_str());
    }
    print_line("%s about the model", scene::plural(left.lints.size(), "warning").c_str());
    print_lints(left.lints);
}

}  // namespace campuswalk::tools
