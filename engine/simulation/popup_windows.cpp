#include "engine/simulation/popup_windows.h"

#include <string>

#include "engine/events/popup_text.h"

namespace campuswalk::engine {

namespace {

PopupTiming timing_of(const scene::PopupRule& rule, const SimSettings& sim) {
    return {rule.once, sim.ticks_of(rule.cooldown), sim.ticks_of(rule.dwell)};
}

/// An object may be in contact in each of the three detection modes.
std::size_t number_of(const DetectedTransition& contact) {
    return 3 * index_of(contact.transition.object) + static_cast<std::size_t>(contact.mode);
}

/// The building's opening hours and its text.
std::string popup_body(const std::string& hours, const std::string& text) {
    const std::string when = hours.empty() ? "" : "Open " + hours + ".";
    return when + (when.empty() || text.empty() ? "" : " ") + text;
}

}  // namespace

PopupWindows::PopupWindows(const scene::Campus& campus, const Walk& walk)
    : campus_(campus), sim_(walk.sim), popups_(campus.description.buildings.size()) {}

void PopupWindows::contact_began(const DetectedTransition& contact, TickEvents& events) {
    const scene::CampusObject& object = campus_.objects[index_of(contact.transition.object)];
    if (object.popup && object.building &&
        popups_.enter(*object.building, number_of(contact), events.tick,
                      timing_of(object.popup_rule, sim_))) {
        open_window(*object.building, contact.transition.at, events);
    }
}

void PopupWindows::contact_ended(const DetectedTransition& contact, TickEvents& events) {
    const scene::CampusObject& object = campus_.objects[index_of(contact.transition.object)];
    if (object.popup && object.building && popups_.leave(*object.building, number_of(contact), events.tick)) {
        events.add(EventKind::popup_close, campus_.description.buildings[*object.building].id, {},
                   contact.transition.at);
        std::erase_if(open_, [&](const OpenPopup& window) { return window.building == *object.building; });
    }
}

void PopupWindows::open_due(TickEvents& events) {
    for (const std::size_t building : popups_.open_due(events.tick)) {
        open_window(building, 1.0, events);
    }
}

void PopupWindows::open_window(std::size_t index, double at, TickEvents& events) {
    const scene::Building& building = campus_.description.buildings[index];
    const PopupFacts facts{popups_.visits(index), sim_.seconds_at(events.tick)};
    const OpenPopup& window =
        open_.emplace_back(OpenPopup{index, popup_title(building, facts), popup_text(building, facts)});
    events.add(EventKind::popup_open, building.id,
               {{"title", Text{window.title}}, {"body", Text{popup_body(building.hours, window.text)}}}, at);
}

}  // namespace campuswalk::engine
