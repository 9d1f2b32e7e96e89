#include "engine/simulation/instant_steps.h"

#include <cassert>
#include <string>
#include <variant>

#include "engine/events/decimals.h"
#include "engine/script/event_pattern.h"
#include "engine/simulation/enclosure.h"

namespace campuswalk::engine {

namespace {

std::optional<Stop> execute_step(const SnapshotStep& step, SimulationState& state) {
    state.snapshots.push_back(&step);
    state.events.add(EventKind::snapshot_take, step.name, {{"pos", state.body.foot()}});
    return std::nullopt;
}

std::optional<Stop> execute_step(const CrouchStep& step, SimulationState& state) {
    if (step.height == state.body.height()) {
        return std::nullopt;
    }
    if (!state.body.resize(step.height, state.statistics)) {
        StoppedBody body = state.body.in_place();
        body.strides.body.height = step.height;
        Stop stop{step.mark, std::string(kBlockedCode),
                  "there is no headroom for " + fixed(step.height, 2) + " m"};
        stop.reason = reason_of_low_headroom(state.campus, body);
        if (const auto by = state.body.obstruction(step.height, state.statistics)) {
            stop.object = state.name_of(*by);
        }
        name_obstacle(stop);
        return stop;
    }
    const bool down = step.height < state.walk.avatar.height;
    state.events.add(down ? EventKind::avatar_crouch : EventKind::avatar_stand, state.walk.name,
                     {{"pos", state.body.foot()}, {"height", Decimal{step.height, 3}}});
    return std::nullopt;
}

/// Handled by the ScriptPlayer.
std::optional<Stop> execute_step(const SpeedStep&, SimulationState&) {
    return std::nullopt;
}

/// Whether any object changed.
bool switch_objects(const EnableStep& step, SimulationState& state) {
    bool changed = false;
    for (std::size_t i = 0; i < state.campus.objects.size(); ++i) {
        const std::string& id = state.campus.objects[i].id;
        if (matches_any(step.objects, id) && state.disabled[i] == step.enabled) {
            state.disabled[i] = !step.enabled;
            changed = true;
            state.events.add(step.enabled ? EventKind::object_enable : EventKind::object_disable, id,
                             {{"pos", state.body.foot()}});
        }
    }
    return changed;
}

std::optional<Stop> execute_step(const EnableStep& step, SimulationState& state) {
    if (!switch_objects(step, state)) {
        return std::nullopt;
    }
    std::optional<Stop> stop;
    if (step.enabled) {
        const Body::Adjustment adjustment = state.body.adjust_to_enabled(state.statistics);
        if (adjustment.enclosed_by) {
            stop = Stop{step.mark, std::string(kEnclosedCode), ""};
            stop->reason = reason_of_enclosure(state.campus, state.body.in_place(), *adjustment.enclosed_by);
            stop->message = text_of(*stop->reason) + "; move the avatar away before 'enable'";
            stop->at = look_at(*stop->reason);
        }
        if (adjustment.push) {
            state.report_push(*adjustment.push, state.walk.name);
        }
    } else {
        state.body.adjust_to_disabled(state.statistics);
    }
    state.contacts.detect_again(state.body, step.enabled ? "enable" : "disabled", state.events,
                                state.statistics);
    return stop;
}

/// The expectations have seen the ticks before this one; they are shown this one so far.
std::optional<Stop> execute_step(const ExpectStep& step, SimulationState& state) {
    auto failure = state.expectations.evaluate(step, state.record());
    if (!failure) {
        return std::nullopt;
    }
    Stop stop{failure->mark, std::move(failure->code), std::move(failure->message),
              std::move(failure->scene)};
    stop.reason = std::move(failure->reason);
    stop.object = std::move(failure->object);
    stop.actual = std::move(failure->actual);
    stop.expected = std::move(failure->expected);
    return stop;
}

/// The other steps are played by intents.
template <typename Lasting>
requires(!InstantStep<Lasting>) std::optional<Stop> execute_step(const Lasting&, SimulationState&) {
    assert(false && "takes time");
    return std::nullopt;
}

}  // namespace

std::optional<Stop> execute(const Step& step, SimulationState& state) {
    return std::visit([&](const auto& each) { return execute_step(each, state); }, step);
}

}  // namespace campuswalk::engine
