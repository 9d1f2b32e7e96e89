#include "engine/script/resolve_targets.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "scene/campus/building_bounds.h"

namespace campuswalk::engine {

namespace {

struct {
    const CameraTarget* operator()(const OrbitView& view) const {
        return view.around ? &*view.around : nullptr;
    }
    const CameraTarget* operator()(const FixedView& view) const {
        return view.look_at ? &*view.look_at : nullptr;
    }
    template <typename Other>
    const CameraTarget* operator()(const Other&) const {
        return nullptr;
    }
} constexpr kTarget;

/// Where buildings are, measured once one of them is asked for.
class BuildingAim {
public:
    explicit BuildingAim(const scene::Campus& campus) : campus_(campus) {}

    /// Where nothing tells where it is, the origin and an error.
    Eigen::Vector3d middle_of(std::size_t building, const SourceMark& mark) {
        if (!bounds_) {
            bounds_ = scene::building_bounds(campus_);
        }
        const scene::Bounds& bounds = (*bounds_)[building];
        if (!bounds.empty()) {
            return bounds.center();
        }
        diagnostics_.push_back({scene::Severity::error, mark, "no-extent",
                                "nothing tells where building '" +
                                    campus_.description.buildings[building].id +
                                    "' is: give it nodes or a collider, or aim at a place"});
        return Eigen::Vector3d::Zero();
    }

    void check(const View& view) {
        const CameraTarget* target = std::visit(kTarget, view);
        if (target != nullptr && target->building) {
            middle_of(*target->building, target->mark);
        }
    }

    std::vector<scene::Diagnostic> take_diagnostics() { return std::move(diagnostics_); }

private:
    const scene::Campus& campus_;
    std::vector<scene::Diagnostic> diagnostics_;
    std::optional<std::vector<scene::Bounds>> bounds_;
};

}  // namespace

std::vector<scene::Diagnostic> resolve_targets(const scene::Campus& campus, Walk& walk) {
    BuildingAim aim(campus);
    aim.check(walk.camera.view);
    for (Step& step : walk.steps) {
        if (auto* look_at = std::get_if<LookAtStep>(&step); look_at != nullptr && look_at->building) {
            look_at->target.point = aim.middle_of(*look_at->building, look_at->mark);
            look_at->building.reset();
        } else if (auto* teleport = std::get_if<TeleportStep>(&step);
                   teleport != nullptr && teleport->place) {
            teleport->position = campus.description.places[*teleport->place].position;
            teleport->place.reset();
        } else if (const auto* snapshot = std::get_if<SnapshotStep>(&step)) {
            aim.check(snapshot->camera.view);
        }
    }
    return aim.take_diagnostics();
}

bool is_resolved(const Walk& walk) {
    return std::ranges::none_of(walk.steps, [](const Step& step) {
        const auto* look_at = std::get_if<LookAtStep>(&step);
        const auto* teleport = std::get_if<TeleportStep>(&step);
        return (look_at != nullptr && look_at->building) || (teleport != nullptr && teleport->place);
    });
}

std::vector<scene::Diagnostic> check_aim(const scene::Campus& campus, const View& view) {
    BuildingAim aim(campus);
    aim.check(view);
    return aim.take_diagnostics();
}

}  // namespace campuswalk::engine
