#include "engine/simulation/check_walk.h"

#include <algorithm>
#include <string>
#include <utility>

#include "collision/world/placement.h"
#include "engine/events/decimals.h"
#include "engine/expect/image_names.h"
#include "engine/expect/name_check.h"
#include "engine/script/avatar_body.h"
#include "engine/simulation/body.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

using Eigen::Vector3d;
using scene::Diagnostic;

namespace {

/// Goes through the steps as they will be played: how tall the avatar is and what is disabled by then.
class StepCheck {
public:
    StepCheck(const scene::Campus& campus, const Walk& walk)
        : campus_(campus),
          avatar_(walk.avatar),
          height_(walk.avatar.height),
          disabled_(campus.objects.size(), false),
          solids_{collision::Detection::solid, ignored_layers(campus, walk.avatar), &disabled_} {}

    /// Appends the diagnostics about it.
    void see(const Step& step, std::vector<Diagnostic>& diagnostics) {
        if (const auto* spawn = std::get_if<SpawnStep>(&step)) {
            check_place(spawn->mark, spawn->label, spawn->position, diagnostics);
        } else if (const auto* teleport = std::get_if<TeleportStep>(&step)) {
            check_place(teleport->mark, teleport->label, teleport->position, diagnostics);
        } else if (const auto* crouch = std::get_if<CrouchStep>(&step)) {
            height_ = crouch->height;
        } else if (const auto* enable = std::get_if<EnableStep>(&step)) {
            for (const NamePattern& pattern : enable->objects) {
                switch_objects(pattern, enable->enabled, diagnostics);
            }
        }
    }

private:
    /// Complains about a place where the avatar can't stand.
    void check_place(const SourceMark& mark, const std::string& label, const Vector3d& foot,
                     std::vector<Diagnostic>& diagnostics) {
        if (collision::nearest_free_placement(campus_.world, solids_, foot, avatar_.radius, height_,
                                              kPlacementSearch)) {
            return;
        }
        const auto object = collision::obstruction(campus_.world, solids_, foot, avatar_.radius, height_);
        const std::string where = object ? "inside " + campus_.objects[index_of(*object)].id : "not free";
        diagnostics.push_back({scene::Severity::error, mark, "spawn-blocked",
                               label + " at " + fixed(foot) + " is " + where +
                                   ": put it where a capsule of " + fixed(avatar_.radius, 2) +
                                   " m radius and " + fixed(height_, 2) + " m height fits"});
    }

    void switch_objects(const NamePattern& pattern, bool enabled, std::vector<Diagnostic>& diagnostics) {
        bool known = false;
        for (std::size_t i = 0; i < campus_.objects.size(); ++i) {
            if (scene::glob_matches(pattern.glob, campus_.objects[i].id)) {
                disabled_[i] = !enabled;
                known = true;
            }
        }
        if (!known) {
            diagnostics.push_back({scene::Severity::error, pattern.mark, "unknown-name",
                                   "the campus has no object '" + pattern.glob + "'" +
                                       scene::did_you_mean(pattern.glob, object_names())});
        }
    }

    std::vector<std::string> object_names() const {
        std::vector<std::string> names;
        for (const scene::CampusObject& object : campus_.objects) {
            names.push_back(object.id);
        }
        return names;
    }

    const scene::Campus& campus_;
    const AvatarProfile& avatar_;
    double height_;
    std::vector<bool> disabled_;
    collision::QueryFilter solids_;
};

bool same_diagnostic(const Diagnostic& a, const Diagnostic& b) {
    return a.mark.file == b.mark.file && a.mark.line == b.mark.line && a.mark.column == b.mark.column &&
           a.message == b.message;
}

/// Steps of a `repeat` are there once a round.
void drop_repeated(std::vector<Diagnostic>& diagnostics) {
    std::vector<Diagnostic> kept;
    for (Diagnostic& diagnostic : diagnostics) {
        if (std::ranges::none_of(kept, [&](const Diagnostic& k) { return same_diagnostic(k, diagnostic); })) {
            kept.push_back(std::move(diagnostic));
        }
    }
    diagnostics = std::move(kept);
}

}  // namespace

std::vector<Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk) {
    std::vector<Diagnostic> diagnostics;
    const NameCheck names(campus, walk);
    StepCheck steps(campus, walk);
    for (const Step& step : walk.steps) {
        steps.see(step, diagnostics);
        if (const auto* wait = std::get_if<WaitUntilStep>(&step)) {
            names.check(wait->event, diagnostics);
        } else if (const auto* expect = std::get_if<ExpectStep>(&step)) {
            names.check(expect->expectations, diagnostics);
        }
    }
    names.check(walk.expectations, diagnostics);
    check_image_names(campus, walk, diagnostics);
    drop_repeated(diagnostics);
    return diagnostics;
}

}  // namespace campuswalk::engine
