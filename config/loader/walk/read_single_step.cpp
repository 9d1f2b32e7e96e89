#include "config/loader/walk/read_single_step.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/mover/mover_settings.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/ranges.h"
#include "config/loader/walk/read_expectations.h"
#include "config/loader/walk/read_pattern.h"

namespace campuswalk::config {

using namespace engine;

namespace {

constexpr std::array kSwitch = {Choice<bool>{"on", true}, Choice<bool>{"off", false}};

constexpr double kJumpHeight = 0.4;  // metres: an untrained adult from standing

/// The keys that the steps along a path have in common.
template <typename StepAlongPath>
void read_path_options(CheckedMap& map, StepAlongPath& step) {
    constexpr std::array kIfBlocked = {Choice<IfBlocked>{"fail", IfBlocked::fail},
                                       Choice<IfBlocked>{"continue", IfBlocked::proceed}};
    map.number("within", kDistance, step.within);
    map.number("timeout", kTimeout, step.timeout);
    map.number("speed", kSpeed, step.speed);
    map.choice("if_blocked", kIfBlocked, step.if_blocked);
    map.refuse_other_keys();
}

std::vector<Target> read_points(const CheckedNode& node, const StepContext& context) {
    std::vector<Target> points;
    for (const CheckedNode& item : node.items("a point")) {
        points.push_back(context.names.campus.target(item));
    }
    if (points.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value", node.what() + " needs at least one point");
    }
    return points;
}

/// The upward speed that carries a body `height` metres up.
double takeoff_speed(double height) {
    return std::sqrt(2.0 * collision::MoverSettings{}.gravity * height);
}

Step read_switched(const CheckedNode& node, bool enabled) {
    EnableStep step;
    step.mark = node.mark();
    step.enabled = enabled;
    for (const CheckedNode& item : node.items_or_one("an object")) {
        if (std::optional<std::string> glob = name_in(item)) {
            step.objects.push_back({item.mark(), std::move(*glob)});
        }
    }
    if (step.objects.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value", node.what() + " needs at least one object's id");
    }
    return step;
}

// ---- places and paths -----------------------------------------------------------------------------------

Step read_spawn(const CheckedNode& node, StepContext& context) {
    if (!context.first) {
        node.diagnose("bad-value", "'spawn' can only be the first step; use 'teleport' here");
    }
    const Placement placement = context.names.campus.spawn(node);
    return SpawnStep{node.mark(), placement.label, placement.position, placement.yaw.value_or(0.0),
                     placement.fall};
}

Step read_teleport(const CheckedNode& node, StepContext& context) {
    Placement placement = context.names.campus.teleport(node);
    return TeleportStep{node.mark(), std::move(placement.label), placement.position, placement.yaw,
                        placement.place};
}

Step read_walk_to(const CheckedNode& node, StepContext& context) {
    WalkToStep step;
    step.mark = node.mark();
    if (!node.is_map()) {
        step.target = context.names.campus.target(node);
        return step;
    }
    CheckedMap map(node, "'walk_to'");
    if (const auto to = map.require("to")) {
        step.target = context.names.campus.target(*to);
    }
    read_path_options(map, step);
    return step;
}

/// An object's id or glob, or `{center, radius}`.
std::optional<Avoided> read_avoided(const CheckedNode& node, const StepContext& context) {
    Avoided avoided;
    if (!node.is_map()) {
        std::optional<std::string> glob = name_in(node);
        avoided.objects = NamePattern{node.mark(), glob.value_or("")};
        return glob ? std::optional(avoided) : std::nullopt;
    }
    constexpr Range kRadius{0.0, 1e6, true, "m"};
    CheckedMap map(node, "what to avoid");
    if (const auto center = map.require("center")) {
        avoided.center = context.names.campus.target(*center);
    }
    map.require("radius");
    map.number("radius", kRadius, avoided.radius);
    map.refuse_other_keys();
    return avoided;
}

/// One of them, or a list.
std::vector<Avoided> read_all_avoided(const CheckedNode& node, const StepContext& context) {
    std::vector<Avoided> all;
    const auto add = [&](const CheckedNode& item) {
        if (auto avoided = read_avoided(item, context)) {
            all.push_back(std::move(*avoided));
        }
    };
    if (node.is_map()) {
        add(node);
        return all;
    }
    std::ranges::for_each(node.items_or_one("an object or {center, radius}"), add);
    if (all.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value", node.what() + " needs at least one object's id or {center, radius}");
    }
    return all;
}

Step read_go_to(const CheckedNode& node, StepContext& context) {
    GoToStep step;
    step.mark = node.mark();
    if (!node.is_map()) {
        step.target = context.names.campus.target(node);
        return step;
    }
    CheckedMap map(node, "'go_to'");
    if (const auto to = map.require("to")) {
        step.target = context.names.campus.target(*to);
    }
    if (const auto through = map.find("through")) {
        step.through = read_points(*through, context);
    }
    if (const auto avoid = map.find("avoid")) {
        step.avoid = read_all_avoided(*avoid, context);
    }
    constexpr std::array kPrefer = {Choice<RoutePreference>{"shortest", RoutePreference::shortest},
                                    Choice<RoutePreference>{"wide", RoutePreference::wide}};
    map.choice("prefer", kPrefer, step.prefer);
    map.number("within", kDistance, step.within);
    map.number("timeout", kTimeout, step.timeout);
    map.number("speed", kSpeed, step.speed);
    map.refuse_other_keys();
    return step;
}

Step read_follow(const CheckedNode& node, StepContext& context) {
    FollowStep step;
    step.mark = node.mark();
    if (!node.is_map()) {
        step.points = read_points(node, context);
        return step;
    }
    CheckedMap map(node, "'follow'");
    if (const auto through = map.require("through")) {
        step.points = read_points(*through, context);
    }
    read_path_options(map, step);
    return step;
}

// ---- looking --------------------------------------------------------------------------------------------

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
    Sight sight = context.names.campus.sight(node);
    return LookAtStep{node.mark(), std::move(sight.target), sight.building};
}

Step read_snapshot(const CheckedNode& node, StepContext& context) {
    SnapshotStep step;
    step.mark = node.mark();
    step.camera = context.camera.settings();
    if (context.repeats > 0) {
        node.diagnose("bad-value",
                      "snapshots aren't allowed in 'repeat': every round would write the same picture");
    }
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
    CameraKeys camera = context.camera;
    read_camera_fields(map, context.names.campus, camera);
    step.camera = camera.settings();
    const bool knows_view = map.has("view") || !context.standalone;
    if (knows_view) {
        refuse_unused_keys(map, step.camera.view);
    }
    if (const auto overlays = map.find("overlays")) {
        read_overlays(*overlays, step.overlays);
        if (step.overlays.grid && knows_view && !std::holds_alternative<engine::TopView>(step.camera.view)) {
            overlays->diagnose("bad-value",
                               "'grid' has no effect on a view in perspective; it is for view: top");
        }
    }
    if (const auto level = map.find("tree_level")) {
        constexpr int kMaxTreeLevel = 40;
        step.overlays.tree_level = level->as_int(0, kMaxTreeLevel);
    }
    if (const auto channels = map.find("channels")) {
        step.channels = read_channels(*channels);
        // Their files are beside other snapshots', so their names must differ, too.
        for (const char* ending : {"-depth", "-ids", "-normals"}) {
            context.snapshots.add(step.name.empty() ? "" : step.name + ending, *channels);
        }
    }
    map.refuse_other_keys();
    return step;
}

// ---- the body -------------------------------------------------------------------------------------------

Step read_jump(const CheckedNode& node, StepContext& /*context*/) {
    constexpr Range kHeight{0.0, 20.0, true, "m"};
    constexpr Range kForward{0.0, 100.0, false, "m/s"};
    JumpStep step;
    step.mark = node.mark();
    step.speed = takeoff_speed(kJumpHeight);
    if (node.is_null()) {
        return step;
    }
    if (!node.is_map()) {
        step.speed = takeoff_speed(node.number(kHeight).value_or(kJumpHeight));
        return step;
    }
    CheckedMap map(node, "'jump'");
    if (const auto height = map.find("height")) {
        step.speed = takeoff_speed(height->number(kHeight).value_or(kJumpHeight));
    }
    map.number("speed", kSpeed, step.speed);
    if (map.has("height") && map.has("speed")) {
        map.diagnose_at("speed", "bad-value", "'jump' takes 'height' or 'speed', not both");
    }
    map.number("forward", kForward, step.forward);
    map.refuse_other_keys();
    return step;
}

Step read_crouch(const CheckedNode& node, StepContext& context) {
    const AvatarProfile& avatar = context.avatar;
    const double lowest = 2.0 * avatar.radius;
    CrouchStep step;
    step.mark = node.mark();
    step.height = crouched_height(avatar);
    if (!node.is_map()) {
        if (!node.choice(kSwitch).value_or(true)) {
            step.height = avatar.height;
        }
        return step;
    }
    CheckedMap map(node, "'crouch'");
    map.require("height");
    map.number("height", {lowest, avatar.height, false, "m (this avatar's width and height)"}, step.height);
    map.refuse_other_keys();
    return step;
}

Step read_run(const CheckedNode& node, StepContext& context) {
    const bool runs = node.choice(kSwitch).value_or(true);
    return SpeedStep{node.mark(), runs ? running_speed(context.avatar) : context.avatar.speed};
}

Step read_speed(const CheckedNode& node, StepContext& context) {
    return SpeedStep{node.mark(), node.number(kSpeed).value_or(context.avatar.speed)};
}

// ---- expecting, waiting and changing the campus -----------------------------------------------------------

Step read_expect(const CheckedNode& node, StepContext& context) {
    return ExpectStep{node.mark(), read_step_expectations(node, context.names)};
}

Step read_wait(const CheckedNode& node, StepContext& /*context*/) {
    return WaitStep{node.mark(), node.number(kSeconds).value_or(0.0)};
}

Step read_wait_until(const CheckedNode& node, StepContext& /*context*/) {
    WaitUntilStep step;
    step.mark = node.mark();
    if (!node.is_map()) {
        step.event = read_pattern(node);
        return step;
    }
    CheckedMap map(node, "'wait_until'");
    if (const auto event = map.require("event")) {
        step.event = read_pattern(*event);
    }
    map.number("timeout", kTimeout, step.timeout);
    map.refuse_other_keys();
    return step;
}

Step read_enable(const CheckedNode& node, StepContext& /*context*/) {
    return read_switched(node, true);
}

Step read_disable(const CheckedNode& node, StepContext& /*context*/) {
    return read_switched(node, false);
}

constexpr std::array kStepReaders = {StepReader{"spawn", read_spawn},
                                     StepReader{"walk_to", read_walk_to},
                                     StepReader{"go_to", read_go_to},
                                     StepReader{"follow", read_follow},
                                     StepReader{"run", read_run},
                                     StepReader{"speed", read_speed},
                                     StepReader{"jump", read_jump},
                                     StepReader{"crouch", read_crouch},
                                     StepReader{"expect", read_expect},
                                     StepReader{"wait", read_wait},
                                     StepReader{"wait_until", read_wait_until},
                                     StepReader{"turn", read_turn},
                                     StepReader{"look_at", read_look_at},
                                     StepReader{"teleport", read_teleport},
                                     StepReader{"enable", read_enable},
                                     StepReader{"disable", read_disable},
                                     StepReader{"snapshot", read_snapshot}};

}  // namespace

std::span<const StepReader> step_readers() {
    return kStepReaders;
}

}  // namespace campuswalk::config
