#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What each kind of event can be about on a campus and a walk: the names in the log's object column.
class EventSubjects {
public:
    EventSubjects(const scene::Campus& campus, const Walk& walk);

    /// Whether an event of the pattern's kinds could be about an object that the pattern names. `*` contains
    /// no name that could be mistyped, so it is always possible.
    bool can_happen(const EventPattern& pattern) const;
    /// Everything that events of the pattern's kinds can be about.
    std::vector<std::string> names(const EventPattern& pattern) const;

private:
    void add_objects(const scene::Campus& campus);
    void add_step(const Step& step, const Walk& walk);
    void add_switched(const StepPreview::Switch& step, const Walk& walk);

    std::vector<std::string> objects_;
    std::map<EventKind, std::vector<std::string>> names_;
};

}  // namespace campuswalk::engine
