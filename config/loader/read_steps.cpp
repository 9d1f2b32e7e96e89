#include "config/loader/read_steps.h"

#include <array>

#include "config/loader/checked_map.h"
#include "config/loader/names.h"
#include "config/loader/ranges.h"
#include "config/loader/read_camera.h"
#include "config/loader/single_key.h"

namespace campuswalk::config {

using engine::CameraSettings;
using engine::IfBlocked;
using engine::LookAtStep;
using engine::SnapshotStep;
using engine::SpawnStep;
using engine::Step;
using engine::TeleportStep;
using engine::TurnStep;
using engine::WaitStep;
using engine::WalkToStep;

namespace {

/// What the readers of single steps share.
struct StepContext {
    const CampusNames& names;
    const CameraSettings& camera;
    UniqueNames snapshots{"snapshot"};
    bool first = true;
};

Step read_spawn(const CheckedNode& node, StepContext& context) {
    if (!context.first) {
        node.complain("bad-value", "'spawn' can only be the first step; later it is 'teleport'");
    }
    const Standing standing = context.names.standing(node);
    return SpawnStep{node.mark(), standing.label, standing.position, standing.yaw.value_or(0.0)};
}

Step read_walk_to(const CheckedNode& node, StepContext& context) {
    constexpr std::array kIfBlocked = {Choice<IfBlocked>{"fail", IfBlocked::fail},
                                       Choice<IfBlocked>{"continue", IfBlocked::proceed}};
    WalkToStep step;
    step.mark = node.mark();
    if (!node.is_map()) {
        step.target = context.names.target(node);
        return step;
    }
    CheckedMap map(node, "'walk_to'");
    if (const auto to = map.require("to")) {
        step.target = context.names.target(*to);
    }
    map.number("within", kDistance, step.within);
    map.number("timeout", {0.0, kSeconds.most, true, "s"}, step.timeout);
    map.number("speed", {0.0, 100.0, true, "m/s"}, step.speed);
    map.choice("if_blocked", kIfBlocked, step.if_blocked);
    map.refuse_other_keys();
    return step;
}

Step read_wait(const CheckedNode& node, StepContext& /*context*/) {
    return WaitStep{node.mark(), node.number(kSeconds).value_or(0.0)};
}

Step read_turn(const CheckedNode& node, StepContext& /*context*/) {
    TurnStep step;
    step.mark = node.mark();
    if (!node.is_map()) {
        step.angle = radians(node.number(kYaw).value_or(0.0));
        return step;
    }
    CheckedMap map(node, "'turn'");
    map.require("to_deg");
    map.angle("to_deg", kYaw, step.angle);
    map.refuse_other_keys();
    step.absolute = true;
    return step;
}

Step read_look_at(const CheckedNode& node, StepContext& context) {
    return LookAtStep{node.mark(), context.names.target(node)};
}

Step read_teleport(const CheckedNode& node, StepContext& context) {
    Standing standing = context.names.standing(node);
    return TeleportStep{node.mark(), std::move(standing.label), standing.position, standing.yaw};
}

Step read_snapshot(const CheckedNode& node, StepContext& context) {
    SnapshotStep step;
    step.mark = node.mark();
    step.camera = context.camera;
    const auto take_name = [&](const CheckedNode& name) {
        step.name = kebab_name(name).value_or("");
        context.snapshots.add(step.name, name);
    };
    if (!node.is_map()) {
        take_name(node);
        return step;
    }
    CheckedMap map(node, "'snapshot'");
    if (const auto name = map.require("name")) {
        take_name(*name);
    }
    read_camera_fields(map, step.camera);
    map.refuse_other_keys();
    return step;
}

using StepReader = Step (*)(const CheckedNode&, StepContext&);
constexpr std::array kSteps = {
    Choice<StepReader>{"spawn", read_spawn},      Choice<StepReader>{"walk_to", read_walk_to},
    Choice<StepReader>{"wait", read_wait},        Choice<StepReader>{"turn", read_turn},
    Choice<StepReader>{"look_at", read_look_at},  Choice<StepReader>{"teleport", read_teleport},
    Choice<StepReader>{"snapshot", read_snapshot}};

}  // namespace

std::vector<Step> read_steps(const CheckedNode& section, const CampusNames& names,
                             const CameraSettings& camera) {
    std::vector<Step> steps;
    StepContext context{names, camera};
    const std::vector<CheckedNode> nodes = section.items("a step");
    for (const CheckedNode& node : nodes) {
        const auto step = single_key(node, "a step", kSteps);
        if (step) {
            if (context.first && step->meaning != read_spawn) {
                node.complain("bad-value", "the first step must be 'spawn', as in 'spawn: main-gate'");
            }
            steps.push_back(step->meaning(step->value, context));
        }
        context.first = false;
    }
    if (nodes.empty() && (section.is_sequence() || section.is_null())) {
        section.complain("bad-value", "'steps' needs at least a spawn");
    }
    return steps;
}

}  // namespace campuswalk::config
