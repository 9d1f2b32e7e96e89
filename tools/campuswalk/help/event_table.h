#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/events/event.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::help {

/// An event as its reader sees it; the documentation's tables are made of these.
struct EventDescription {
    engine::EventKind kind = engine::EventKind::walk_start;
    std::string_view object;  ///< what the log's column OBJECT names
    std::string_view when;    ///< when it occurs
};

/// A detail that events carry.
struct FieldDescription {
    std::string_view name;
    std::string_view value;  ///< its type in words
    std::string_view meaning;
    std::vector<engine::EventKind> events;  ///< that carry it
};

/// All kinds, in their order.
std::vector<EventDescription> event_descriptions();

/// All fields, in the order in which logs print them.
std::vector<FieldDescription> field_descriptions();

/// A line for each event: its name, its object, when it occurs.
std::string event_lines();

/// `{"campuswalk_events": 1, "events": [{"event", "object", "when", "fields": [NAME, …]}, …], "fields":
/// [{"field", "value", "meaning"}, …]}`
Json event_json();

}  // namespace campuswalk::tools::help
