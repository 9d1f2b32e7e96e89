#pragma once

#include <span>
#include <vector>

#include "engine/events/popups.h"
#include "engine/record/tick_record.h"
#include "engine/script/walk.h"
#include "engine/simulation/contact_detector.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// The buildings' information windows, which open and close with the contacts of the buildings' objects.
class PopupWindows {
public:
    /// Both must outlive it.
    PopupWindows(const scene::Campus& campus, const Walk& walk);

    /// After a contact's enter, and before its exit. Objects without a pop-up are ignored.
    void contact_began(const DetectedTransition& contact, TickEvents& events);
    void contact_ended(const DetectedTransition& contact, TickEvents& events);
    /// Opens the windows for which a contact has now lasted long enough.
    void open_due(TickEvents& events);

    std::span<const OpenPopup> open() const { return open_; }  ///< oldest first

private:
    void open_window(std::size_t building, double at, TickEvents& events);

    const scene::Campus& campus_;
    const SimSettings& sim_;
    Popups popups_;
    std::vector<OpenPopup> open_;
};

}  // namespace campuswalk::engine
