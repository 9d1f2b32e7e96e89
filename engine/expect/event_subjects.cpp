#include "engine/expect/event_subjects.h"

#include <algorithm>
#include <initializer_list>

#include "scene/glob.h"

namespace campuswalk::engine {

using collision::Detection;

EventSubjects::EventSubjects(const scene::Campus& campus, const Walk& walk) {
    for (const EventKind kind :
         {EventKind::walk_start, EventKind::walk_end, EventKind::avatar_land, EventKind::avatar_fell}) {
        names_[kind] = {walk.name};
    }
    add_objects(campus);
    add_steps(walk);
}

void EventSubjects::add_objects(const scene::Campus& campus) {
    const auto add = [&](std::initializer_list<EventKind> kinds, const std::string& name) {
        for (const EventKind kind : kinds) {
            names_[kind].push_back(name);
        }
    };
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const scene::CampusObject& object = campus.objects[i];
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

void EventSubjects::add_steps(const Walk& walk) {
    for (const Step& step : walk.steps) {
        if (const auto* spawn = std::get_if<SpawnStep>(&step)) {
            if (&step != &walk.steps.front()) {  // the first is told by walk.start
                names_[EventKind::avatar_spawn].push_back(spawn->label);
            }
        } else if (const auto* teleport = std::get_if<TeleportStep>(&step)) {
            names_[EventKind::avatar_teleport].push_back(teleport->label);
        } else if (const auto* walk_to = std::get_if<WalkToStep>(&step)) {
            names_[EventKind::avatar_arrive].push_back(walk_to->target.label);
            names_[EventKind::avatar_blocked].push_back(walk_to->target.label);
        } else if (const auto* snapshot = std::get_if<SnapshotStep>(&step)) {
            names_[EventKind::snapshot_take].push_back(snapshot->name);
        }
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
