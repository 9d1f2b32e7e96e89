#include "engine/expect/event_subjects.h"

#include <algorithm>
#include <array>
#include <set>

#include "engine/script/event_pattern.h"
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
    struct DetectionKinds {
        Detection detection;
        std::array<EventKind, 3> kinds;
    };
    constexpr DetectionKinds kDetected[] = {
        {Detection::solid,
         {EventKind::collision_enter, EventKind::collision_stay, EventKind::collision_exit}},
        {Detection::trigger, {EventKind::trigger_enter, EventKind::trigger_stay, EventKind::trigger_exit}},
        {Detection::ray, {EventKind::ray_enter, EventKind::ray_stay, EventKind::ray_exit}}};
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const scene::CampusObject& object = campus.objects[i];
        objects_.push_back(object.id);
        for (const auto& [detection, kinds] : kDetected) {
            if (any_of(campus.world.object(static_cast<collision::ObjectId>(i)).detection, detection)) {
                for (const EventKind kind : kinds) {
                    names_[kind].push_back(object.id);
                }
            }
        }
        if (object.popup && object.building) {
            for (const EventKind kind : {EventKind::popup_open, EventKind::popup_close}) {
                names_[kind].push_back(campus.description.buildings[*object.building].id);
            }
        }
    }
}

void EventSubjects::add_step(const Step& step, const Walk& walk) {
    const StepPreview preview = preview_of(step);
    for (const auto& [kind, object] : preview.events) {
        // walk.start stands for the first spawn.
        if (kind != EventKind::avatar_spawn || &step != &walk.steps.front()) {
            names_[kind].push_back(object.value_or(walk.name));
        }
    }
    if (preview.height) {
        const bool down = *preview.height < walk.avatar.height;
        names_[down ? EventKind::avatar_crouch : EventKind::avatar_stand].push_back(walk.name);
    }
    if (preview.switched) {
        add_switched(*preview.switched, walk);
    }
}

/// An avatar that an enabled object pushes aside is logged with the walk's name.
void EventSubjects::add_switched(const StepPreview::Switch& step, const Walk& walk) {
    const EventKind kind = step.enabled ? EventKind::object_enable : EventKind::object_disable;
    for (const std::string& object : objects_) {
        if (matches_any(step.objects, object)) {
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
