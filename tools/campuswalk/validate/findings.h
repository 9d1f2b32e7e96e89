#pragma once

#include <string>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

/// A file that was checked; paths are as the user gave them.
struct CheckedFile {
    std::string file;
    bool valid = false;
    std::string summary;  ///< of its contents, if it is valid
};

/// What `validate` found. An error in a file that several others use is reported once.
struct Findings {
    std::vector<CheckedFile> files;
    std::vector<scene::Diagnostic> diagnostics;
};

/// The same with paths as seen from the repository's root, which services know; `start` as in report_paths.h.
Findings with_paths_in_repository(const std::string& start, Findings findings);

// The findings as text for different readers, ending with a line end.

std::string as_json(const Findings& findings);
/// The Static Analysis Results Interchange Format, 2.1.0: what code scanning services read.
std::string as_sarif(const Findings& findings);
/// Workflow commands: GitHub shows each beside its line.
std::string as_github(const Findings& findings);

}  // namespace campuswalk::tools
