#include "engine/simulation/contact_events.h"

#include <algorithm>
#include <string>

#include "engine/script/avatar_body.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

EventKind kind_of(const DetectedTransition& contact) {
    constexpr EventKind kKinds[][3] = {
        {EventKind::collision_exit, EventKind::collision_enter, EventKind::collision_stay},
        {EventKind::trigger_exit, EventKind::trigger_enter, EventKind::trigger_stay},
        {EventKind::ray_exit, EventKind::ray_enter, EventKind::ray_stay}};
    return kKinds[static_cast<std::size_t>(contact.mode)][static_cast<std::size_t>(contact.transition.phase)];
}

/// At least one.
Tick at_least_one_tick(double seconds, const SimSettings& sim) {
    return std::max<Tick>(1, sim.ticks_of(seconds));
}

/// On the tick's path.
Vector3d position_at(double fraction, const std::vector<Vector3d>& path) {
    const std::size_t parts = path.size() - 1;
    if (parts == 0) {
        return path.front();
    }
    const double along = fraction * static_cast<double>(parts);
    const std::size_t part = std::min(parts - 1, static_cast<std::size_t>(along));
    const double rest = along - static_cast<double>(part);
    return path[part] + rest * (path[part + 1] - path[part]);
}

}  // namespace

ContactEvents::ContactEvents(const scene::Campus& campus, const Walk& walk, const std::vector<bool>& disabled,
                             PopupWindows& popups)
    : campus_(campus),
      detector_(campus, walk.avatar, ignored_layers(campus, walk.avatar),
                at_least_one_tick(walk.sim.stay_every, walk.sim),
                at_least_one_tick(walk.sim.gaze_hold, walk.sim), &disabled),
      popups_(popups) {}

void ContactEvents::detect(const Body& body, const char* cause, TickEvents& events,
                           collision::QueryStatistics& statistics) {
    detector_.detect(events.tick, body.state(), body.trace(), transitions_, &statistics);
    report_all(body, cause, events);
}

void ContactEvents::detect_again(const Body& body, const char* cause, TickEvents& events,
                                 collision::QueryStatistics& statistics) {
    detector_.detect_again(events.tick, body.state(), body.trace(), transitions_, &statistics);
    report_all(body, cause, events);
}

void ContactEvents::end_all(const Body& body, const char* cause, TickEvents& events) {
    detector_.leave_all(events.tick, transitions_);
    report_all(body, cause, events);
}

void ContactEvents::report_all(const Body& body, const char* cause, TickEvents& events) {
    for (const DetectedTransition& contact : transitions_) {
        if (contact.transition.phase == Phase::exit) {
            popups_.contact_ended(contact, events);
        }
        report(contact, body, cause, events);
        if (contact.transition.phase == Phase::enter) {
            popups_.contact_began(contact, events);
        }
    }
}

void ContactEvents::report(const DetectedTransition& contact, const Body& body, const char* cause,
                           TickEvents& events) {
    const Transition& t = contact.transition;
    Event& event = events.add(kind_of(contact), campus_.objects[index_of(t.object)].id,
                              {{"pos", position_at(t.at, body.trace().path)}}, t.at);
    if (contact.mode == DetectionMode::trigger && t.phase != Phase::stay && cause == nullptr) {
        event.fields.push_back({"at", Decimal{t.at, 3}});
    }
    if (contact.mode == DetectionMode::ray && t.phase != Phase::exit) {
        event.fields.push_back({"distance", Decimal{contact.distance, 3}});
    }
    if (t.phase != Phase::enter) {
        event.fields.push_back({"ticks", static_cast<std::int64_t>(t.ticks)});
    }
    if (cause != nullptr && t.phase != Phase::stay) {
        event.fields.push_back({"cause", std::string(cause)});
    }
}

}  // namespace campuswalk::engine
