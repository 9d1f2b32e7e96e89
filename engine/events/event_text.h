#pragma once

#include <string>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// The event as one line in fixed columns: tick, seconds, kind, object, then `name=value`s.
std::string text_line(const Event& event, double time);

/// A name as it stands in such a line: bare, or in quotes where it would break the columns.
std::string text_of_name(const std::string& value);

}  // namespace campuswalk::engine
