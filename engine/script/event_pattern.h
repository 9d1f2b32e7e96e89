#pragma once

#include <string>

#include "engine/events/event.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

bool matches(const EventPattern& pattern, const Event& event);

/// As the user writes it: `KIND OBJECT`, or `KIND` alone for any object.
std::string told(const EventPattern& pattern);

}  // namespace campuswalk::engine
