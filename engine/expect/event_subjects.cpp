#include "engine/expect/event_subjects.h"

#include <algorithm>
#include <initializer_list>
#include <set>

#include "scene/base/glob.h"

namespace campuswalk::engine {

using collision::Detection;

namespace {

/// Keeps the first of equal names.
void drop_repeated(std::vector<std::string>& names) {
    std::set<std::string> seen;
    std::erase_if(names, [&](const std::string& name) { return !seen.insert(name).second; });
}

}  // namespace

EventSubjects::EventSubjects(const scene::Campus& campus, const Walk& walk) {
    for (const EventKind kind : {EventKind::walk_start, EventKind::walk_end, EventKind::avatar_landed,
                                 EventKind::avatar_fell, EventKind::avatar_stuck}) {
        names_[kind] = {walk.name};
    }
    add_objects(campus);
    for (const Step& step : walk.steps) {
        add_step(step, walk);
    }
    for (auto& [kind, names] : names_) {
        drop_repeated(names);  // rounds of a `repeat`
    }
}

void EventSubjects::add_objects(const scene::Campus& campus) {
    const auto add = [&](std::initializer_list<EventKind> kinds, const std::string& name) {
        for (const EventKind kind : kinds) {
            names_[kind].push_back(name);
        }
    };
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const scene::CampusObject& object = campus.objects[i];
        objects_.push_back(object.id);
        const Detection detection = campus.world.object(static_cast<collision::ObjectId>(i)).detection;
        if (any_of(detection, Detection::solid)) {
            add({EventKind::collision_enter, EventKind::collision_stay, EventKind::collision_exit},
                object.id);
        }
        if (any_of(detection, Detection::trigger)) {
            add({EventKind::trigger_enter, EventKind::trigger_stay, EventKind::trigger_exit}, object.id);
        }
        if (any_of(detection, Detection::ray)) {
            add({EventKind::ray_enter, EventKind::ray_stay, EventKind::ray_exit}, object.id);
        }
        if (object.popup && object.building) {
            add({EventKind::popup_open, EventKind::popup_close},
                campus.description.buildings[*object.building].id);
        }
    }
}

void EventSubjects::add_step(const Step& step, const Walk& walk) {
    const auto add = [&](std::initializer_list<EventKind> kinds, const std::string& name) {
        for (const EventKind kind : kinds) {
            names_[kind].push_back(name);
        }
    };
    if (const auto* spawn = std::get_if<SpawnStep>(&step)) {
        add({EventKind::avatar_depenetrated}, spawn->label);
        if (&step != &walk.steps.front()) {  // the first is told by walk.start
            add({EventKind::avatar_spawn}, spawn->label);
        }
    } else if (const auto* teleport = std::get_if<TeleportStep>(&step)) {
        add({EventKind::avatar_teleport, EventKind::avatar_depenetrated}, teleport->label);
    } else if (const auto* walk_to = std::get_if<WalkToStep>(&step)) {
        add({EventKind::avatar_arrive, EventKind::avatar_blocked}, walk_to->target.label);
    } else if (const auto* follow = std::get_if<FollowStep>(&step)) {
        add({EventKind::avatar_arrive, EventKind::avatar_blocked}, follow->points.back().label);
    } else if (const auto* snapshot = std::get_if<SnapshotStep>(&step)) {
        add({EventKind::snapshot_take}, snapshot->name);
    } else if (std::holds_alternative<JumpStep>(step)) {
        add({EventKind::avatar_jump}, walk.name);
    } else if (const auto* crouch = std::get_if<CrouchStep>(&step)) {
        const bool down = crouch->height < walk.avatar.height;
        add({down ? EventKind::avatar_crouch : EventKind::avatar_stand}, walk.name);
    } else if (const auto* enable = std::get_if<EnableStep>(&step)) {
        add_switched(*enable, walk);
    }
}

/// What is in the way of an object that appears is told of the walk.
void EventSubjects::add_switched(const EnableStep& step, const Walk& walk) {
    const EventKind kind = step.enabled ? EventKind::object_enable : EventKind::object_disable;
    for (const std::string& object : objects_) {
        if (std::ranges::any_of(step.objects, [&](const auto& pattern) {
                return scene::glob_matches(pattern.glob, object);
            })) {
            names_[kind].push_back(object);
        }
    }
    if (step.enabled) {
        names_[EventKind::avatar_depenetrated].push_back(walk.name);
    }
}

bool EventSubjects::can_happen(const EventPattern& pattern) const {
    const std::vector<std::string> known = names(pattern);
    return pattern.object == "*" || std::ranges::any_of(known, [&](const std::string& name) {
               return scene::glob_matches(pattern.object, name);
           });
}

std::vector<std::string> EventSubjects::names(const EventPattern& pattern) const {
    std::vector<std::string> known;
    for (const auto& [kind, names] : names_) {
        if (scene::glob_matches(pattern.kind, name_of(kind))) {
            known.insert(known.end(), names.begin(), names.end());
        }
    }
    return known;
}

}  // namespace campuswalk::engine
