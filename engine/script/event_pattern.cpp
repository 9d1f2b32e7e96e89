#include "engine/script/event_pattern.h"

#include "scene/base/glob.h"

namespace campuswalk::engine {

bool matches(const EventPattern& pattern, const Event& event) {
    return scene::glob_matches(pattern.kind, name_of(event.kind)) &&
           scene::glob_matches(pattern.object, event.object);
}

std::string told(const EventPattern& pattern) {
    return pattern.object == "*" ? pattern.kind : pattern.kind + " " + pattern.object;
}

}  // namespace campuswalk::engine
