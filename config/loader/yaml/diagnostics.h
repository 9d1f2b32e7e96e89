#pragma once

#include <string>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// Whether the list is so long that more diagnostics would help nobody: a file of 8 MB can have a million
/// errors.
bool is_full(const scene::DiagnosticList& diagnostics);

/// Adds an error unless the list is full; the one that fills it is followed by a last one, too-many.
void add_diagnostic(scene::DiagnosticList& diagnostics, const scene::SourceMark& mark,
                    scene::DiagnosticCode code, std::string message);

/// Throws scene::InputError if there are errors: those in the file of `first`, then those in the files it
/// names, in the order in which they were read, each from top to bottom. Duplicates, from a file that was
/// read twice, are dropped.
void throw_in_order(const scene::DiagnosticList& diagnostics, const scene::SourceMark& first);

}  // namespace campuswalk::config
