#pragma once

#include "tools/campuswalk/suggest/suggest_campus.h"

namespace campuswalk::tools {

/// Prints what was written, what the walk does, how the model is read and what looks wrong with it.
void print_suggestion(const Suggestion& suggestion);

}  // namespace campuswalk::tools
