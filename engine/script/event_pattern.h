#pragma once

#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/script/mentions.h"

namespace campuswalk::engine {

bool matches(const EventPattern& pattern, const Event& event);
bool matches_any(const std::vector<NamePattern>& patterns, const std::string& name);

/// As the user writes it: `KIND OBJECT`, or `KIND` alone for any object.
std::string to_string(const EventPattern& pattern);

}  // namespace campuswalk::engine
