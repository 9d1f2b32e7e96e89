#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

/// About a file, a folder or an option as a whole.
scene::InputError error_about(const std::filesystem::path& subject, scene::DiagnosticCode code,
                              const std::string& message);

/// To standard error, one per line.
void diagnose(const std::vector<scene::Diagnostic>& diagnostics);

/// Returns the command's exit code, or that for what it throws, which is reported.
int report_exceptions(const std::function<int()>& command);

}  // namespace campuswalk::tools
