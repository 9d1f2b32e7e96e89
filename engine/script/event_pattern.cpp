#include "engine/script/event_pattern.h"

#include <algorithm>

#include "scene/base/glob.h"

namespace campuswalk::engine {

bool matches(const EventPattern& pattern, const Event& event) {
    return scene::glob_matches(pattern.kind, name_of(event.kind)) &&
           scene::glob_matches(pattern.object, event.object);
}

bool matches_any(const std::vector<NamePattern>& patterns, const std::string& name) {
    return std::ranges::any_of(patterns,
                               [&](const NamePattern& each) { return scene::glob_matches(each.glob, name); });
}

std::string to_string(const EventPattern& pattern) {
    return pattern.object == "*" ? pattern.kind : pattern.kind + " " + pattern.object;
}

}  // namespace campuswalk::engine
