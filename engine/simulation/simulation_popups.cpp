// Windows open and close beside the contacts that they come with.

#include <cmath>

#include "engine/events/popup_text.h"
#include "engine/simulation/simulation.h"

namespace campuswalk::engine {

namespace {

Tick rounded_ticks(double seconds, const SimSettings& sim) {
    return static_cast<Tick>(std::floor(seconds * sim.ticks_per_second + 0.5));
}

PopupTiming timing_of(const scene::PopupRule& rule, const SimSettings& sim) {
    return {rule.once, rounded_ticks(rule.cooldown, sim), rounded_ticks(rule.dwell, sim)};
}

/// An object may be met in three ways at once.
std::size_t contact_of(const DetectedTransition& detected) {
    return 3 * index_of(detected.transition.object) + static_cast<std::size_t>(detected.mode);
}

/// When the building is open, and its text.
std::string popup_body(const std::string& hours, const std::string& text) {
    const std::string when = hours.empty() ? "" : "Open " + hours + ".";
    return when + (when.empty() || text.empty() ? "" : " ") + text;
}

}  // namespace

void Simulation::meet_popup(const DetectedTransition& detected) {
    const scene::CampusObject& object = campus_.objects[index_of(detected.transition.object)];
    if (popups_.meet(*object.building, contact_of(detected), tick_,
                     timing_of(object.popup_rule, walk_.sim))) {
        open_popup(*object.building, detected.transition.at);
    }
}

void Simulation::leave_popup(const DetectedTransition& detected) {
    const std::size_t building = *campus_.objects[index_of(detected.transition.object)].building;
    if (popups_.leave(building, contact_of(detected), tick_)) {
        add(EventKind::popup_close, campus_.description.buildings[building].id, detected.transition.at);
        std::erase_if(windows_, [&](const OpenPopup& window) { return window.building == building; });
    }
}

void Simulation::report_dwelling() {
    for (const std::size_t building : popups_.open_due(tick_)) {
        open_popup(building, 1.0);
    }
}

void Simulation::open_popup(std::size_t index, double at) {
    const scene::Building& building = campus_.description.buildings[index];
    const PopupFacts facts{popups_.visits(index), static_cast<double>(tick_) / walk_.sim.ticks_per_second};
    windows_.push_back({index, popup_title(building, facts), popup_text(building, facts)});
    const OpenPopup& window = windows_.back();
    add(EventKind::popup_open, building.id, at).fields = {
        {"title", Text{window.title}}, {"body", Text{popup_body(building.hours, window.text)}}};
}

}  // namespace campuswalk::engine
