#include "engine/expect/step_events.h"

#include <algorithm>

#include "engine/script/event_pattern.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

namespace {

/// Whether the step does by itself what this event says.
bool is_done_by_itself(EventKind kind) {
    using enum EventKind;
    return kind == avatar_spawn || kind == avatar_teleport || kind == avatar_jump || kind == snapshot_take;
}

}  // namespace

StepEvents::StepEvents(const scene::Campus& campus, const Walk& walk) {
    std::vector<bool> disabled(campus.objects.size(), false);
    events_.push_back({0, EventKind::walk_start, walk.name, true});
    for (std::size_t i = 0; i < walk.steps.size(); ++i) {
        add(i, walk.steps[i], walk);
        if (const auto switched = preview_of(walk.steps[i]).switched) {
            add_switched(i, *switched, campus, walk, disabled);
        }
    }
    events_.push_back({walk.steps.size(), EventKind::walk_end, walk.name, true});
}

void StepEvents::add(std::size_t index, const Step& step, const Walk& walk) {
    const StepPreview preview = preview_of(step);
    for (const auto& [kind, object] : preview.events) {
        if (index > 0 || kind != EventKind::avatar_spawn) {  // walk.start stands for the first spawn
            events_.push_back({index, kind, object.value_or(walk.name), is_done_by_itself(kind)});
        }
    }
    if (preview.height) {
        const bool down = *preview.height < walk.avatar.height;
        events_.push_back(
            {index, down ? EventKind::avatar_crouch : EventKind::avatar_stand, walk.name, false});
    }
}

void StepEvents::add_switched(std::size_t index, const StepPreview::Switch& step, const scene::Campus& campus,
                              const Walk& walk, std::vector<bool>& disabled) {
    const EventKind kind = step.enabled ? EventKind::object_enable : EventKind::object_disable;
    for (std::size_t i = 0; i < disabled.size(); ++i) {
        if (disabled[i] == step.enabled && matches_any(step.objects, campus.objects[i].id)) {
            disabled[i] = !step.enabled;
            events_.push_back({index, kind, campus.objects[i].id, true});
        }
    }
    if (step.enabled) {
        events_.push_back({index, EventKind::avatar_depenetrated, walk.name, false});
    }
}

bool StepEvents::is_caused_by_steps(EventKind kind) {
    using enum EventKind;
    switch (kind) {
        case walk_start:
        case walk_end:
        case avatar_spawn:
        case avatar_teleport:
        case avatar_arrive:
        case avatar_blocked:
        case avatar_jump:
        case avatar_crouch:
        case avatar_stand:
        case avatar_depenetrated:
        case object_enable:
        case object_disable:
        case snapshot_take:
        case expect_fail:  // of the verdict, which expectations don't see
            return true;
        default:
            return false;
    }
}

bool StepEvents::matches(const EventPattern& pattern, const StepEvent& event) {
    return scene::glob_matches(pattern.kind, name_of(event.kind)) &&
           scene::glob_matches(pattern.object, event.object);
}

Interval StepEvents::times(const EventPattern& event, std::size_t steps) const {
    Interval times;
    for (const StepEvent& each : events_) {
        if (each.step < steps && matches(event, each)) {
            times.least += each.certain ? 1.0 : 0.0;
            times.most += 1.0;
        }
    }
    return times;
}

bool StepEvents::can_come(const std::vector<EventPattern>& in_order, const std::vector<bool>& at_any_time,
                          std::size_t steps) const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < in_order.size(); ++i) {
        if (at_any_time[i]) {
            next = std::max<std::size_t>(next, 1);  // nothing comes before walk.start
            continue;
        }
        while (next < events_.size() &&
               !(events_[next].step < steps && matches(in_order[i], events_[next]))) {
            ++next;
        }
        if (next == events_.size()) {
            return false;
        }
        ++next;
    }
    return true;
}

bool StepEvents::are_certain(const std::vector<EventPattern>& in_order, std::size_t steps) const {
    auto wanted = in_order.begin();
    for (const StepEvent& each : events_) {
        if (wanted != in_order.end() && each.certain && each.step < steps && matches(*wanted, each)) {
            ++wanted;
        }
    }
    return wanted == in_order.end();
}

}  // namespace campuswalk::engine
