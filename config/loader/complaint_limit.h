#pragma once

#include <string>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// Whether so much has been complained of that more would help nobody: a file of 2 MB has room for a million
/// mistakes.
bool is_full(const scene::DiagnosticList& diagnostics);

/// Adds the diagnostic unless the list is full; the one that fills it is followed by a word on that
/// (too-many).
void add_diagnostic(scene::DiagnosticList& diagnostics, const scene::SourceMark& mark, std::string code,
                    std::string message);

}  // namespace campuswalk::config
