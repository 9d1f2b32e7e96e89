#pragma once

#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

/// A line each to standard error.
void diagnose(const std::vector<scene::Diagnostic>& diagnostics);
void diagnostic_line(const std::string& line);

}  // namespace campuswalk::tools
