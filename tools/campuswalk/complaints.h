#pragma once

#include <vector>

#include "scene/diagnostic.h"

namespace campuswalk::tools {

/// A line each to standard error.
void complain(const std::vector<scene::Diagnostic>& diagnostics);

}  // namespace campuswalk::tools
