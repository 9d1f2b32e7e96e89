#pragma once

#include <string>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// Whether the list holds so many diagnostics that more would help nobody: a file of 2 MB has room for a
/// million mistakes.
bool is_full(const scene::DiagnosticList& diagnostics);

/// Adds an error unless the list is full; the one that fills it is followed by a last one that says so
/// (too-many).
void add_diagnostic(scene::DiagnosticList& diagnostics, const scene::SourceMark& mark, std::string code,
                    std::string message);

/// Throws scene::InputError if there are errors: those of the file of `first`, then those of the files it
/// names in the order they were read, each from top to bottom. A file that was read twice is reported once.
void throw_in_order(const scene::DiagnosticList& diagnostics, const scene::SourceMark& first);

}  // namespace campuswalk::config
