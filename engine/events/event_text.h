#pragma once

#include <string>
#include <string_view>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// The event as one line in fixed columns: tick, seconds, kind, object, then `name=value`s.
std::string text_line(const Event& event, double time);

/// Such a line of its parts, as they are; `details` is empty or starts with a space.
std::string text_line(Tick tick, double time, std::string_view kind, const std::string& object,
                      const std::string& details);

/// A name as such a line has it: in quotes only if it would break the columns.
std::string text_of_name(const std::string& value);

}  // namespace campuswalk::engine
