#pragma once

#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/script/mentions.h"

namespace campuswalk::engine {

bool matches(const EventPattern& pattern, const Event& event);
bool matches_any(const std::vector<NamePattern>& patterns, const std::string& name);

/// As users write it: `KIND OBJECT`, or only `KIND` for any object.
std::string to_string(const EventPattern& pattern);

}  // namespace campuswalk::engine
