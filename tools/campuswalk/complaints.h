#pragma once

#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

/// A line each to standard error.
void complain(const std::vector<scene::Diagnostic>& diagnostics);
void complain_line(const std::string& line);

}  // namespace campuswalk::tools
