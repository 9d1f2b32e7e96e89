#pragma once

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// Throws scene::InputError if there are errors: those of the file of `first`, then those of the files it
/// names as they were read, each from top to bottom. A file that was read twice is complained of once.
void throw_in_order(const scene::DiagnosticList& diagnostics, const scene::SourceMark& first);

}  // namespace campuswalk::config
