#include "engine/script/walk.h"

#include <algorithm>
#include <array>
#include <variant>

#include "engine/events/event.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

namespace {

/// Whether it only fits what happens to the visitor, not what steps cause by themselves: waiting for that
/// expects nothing.
bool waits_for_the_campus(const WaitUntilStep& step) {
    using enum EventKind;
    constexpr std::array kOfSteps = {walk_start,    walk_end,       avatar_spawn,  avatar_teleport,
                                     avatar_arrive, avatar_jump,    avatar_crouch, avatar_stand,
                                     object_enable, object_disable, snapshot_take};
    return std::ranges::none_of(
        kOfSteps, [&](EventKind kind) { return scene::glob_matches(step.event.kind, name_of(kind)); });
}

bool expects(const Step& step) {
    const auto* wait = std::get_if<WaitUntilStep>(&step);
    return std::holds_alternative<ExpectStep>(step) || (wait != nullptr && waits_for_the_campus(*wait));
}

}  // namespace

bool expects_something(const Walk& walk) {
    return !walk.expectations.empty() || walk.status.kind == WalkStatus::Kind::xfail ||
           std::ranges::any_of(walk.steps, expects);
}

}  // namespace campuswalk::engine
