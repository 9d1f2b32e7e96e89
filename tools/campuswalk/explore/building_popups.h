#pragma once

#include <cstddef>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// A building's pop-up, and whether anybody can open it.
struct BuildingPopup {
    std::size_t building = 0;  ///< index into CampusDescription::buildings
    /// Objects of which a contact opens it, by the campus file: solids that one touches, triggers that one
    /// enters, objects that one looks at. Those that the visitor doesn't notice are left out.
    std::vector<collision::ObjectId> openers = {};
    bool opens = false;  ///< the visitor comes into contact with one of them
};

/// Of the buildings whose pop-ups some object opens, in the campus file's order. The rule is that of a run
/// (engine/simulation/popup_windows.h): to stand on a solid is no contact.
std::vector<BuildingPopup> building_popups(const scene::Campus& campus, const engine::WalkReport& report);

}  // namespace campuswalk::tools::explore
