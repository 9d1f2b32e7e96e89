#pragma once

#include <vector>

#include "engine/simulation/body.h"
#include "engine/simulation/contact_detector.h"
#include "engine/simulation/popup_windows.h"

namespace campuswalk::engine {

/// The events of contacts that begin, continue and end, together with those of their information windows,
/// which open after the enter and close before the exit.
class ContactEvents {
public:
    /// `disabled` is by object. All must outlive it.
    ContactEvents(const scene::Campus& campus, const Walk& walk, const std::vector<bool>& disabled,
                  PopupWindows& popups);

    /// After the body has moved. `cause` says why contacts change; null if it is by the avatar's own motion.
    void detect(const Body& body, const char* cause, TickEvents& events,
                collision::QueryStatistics& statistics);
    /// In the same tick, after objects have been enabled or disabled.
    void detect_again(const Body& body, const char* cause, TickEvents& events,
                      collision::QueryStatistics& statistics);
    /// Ends all contacts.
    void end_all(const Body& body, const char* cause, TickEvents& events);

private:
    void report_all(const Body& body, const char* cause, TickEvents& events);
    void report(const DetectedTransition& contact, const Body& body, const char* cause, TickEvents& events);

    const scene::Campus& campus_;
    ContactDetector detector_;
    PopupWindows& popups_;
    std::vector<DetectedTransition> transitions_;  ///< a member to reuse its memory
};

}  // namespace campuswalk::engine
