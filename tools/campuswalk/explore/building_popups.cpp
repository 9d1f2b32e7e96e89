#include "tools/campuswalk/explore/building_popups.h"

#include <map>
#include <string>

namespace campuswalk::tools::explore {

namespace {

/// By the id of the objects that the visitor notices: whether a contact with it is possible.
std::map<std::string, bool> contacts_of(const scene::Campus& campus, const engine::WalkReport& report) {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        numbers.emplace(campus.objects[i].id, i);
    }
    std::map<std::string, bool> contacts;
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        const bool is_solid = subject.kind == engine::SubjectKind::solid;
        if (!is_solid && subject.kind != engine::SubjectKind::trigger &&
            subject.kind != engine::SubjectKind::ray) {
            continue;
        }
        const bool possible = is_solid ? report.space.touched[numbers.at(subject.name)] : subject.reached;
        bool& contact = contacts[subject.name];
        contact = contact || possible;
    }
    return contacts;
}

}  // namespace

std::vector<BuildingPopup> building_popups(const scene::Campus& campus, const engine::WalkReport& report) {
    const std::map<std::string, bool> contacts = contacts_of(campus, report);
    std::vector<BuildingPopup> all(campus.description.buildings.size());
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const scene::CampusObject& object = campus.objects[i];
        const auto contact = contacts.find(object.id);
        if (!object.popup || !object.building || contact == contacts.end()) {
            continue;
        }
        BuildingPopup& popup = all[*object.building];
        popup.openers.push_back(static_cast<collision::ObjectId>(i));
        popup.opens = popup.opens || contact->second;
    }
    std::vector<BuildingPopup> popups;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].openers.empty()) {
            all[i].building = i;
            popups.push_back(std::move(all[i]));
        }
    }
    return popups;
}

}  // namespace campuswalk::tools::explore
