#pragma once

#include "scene/base/binary_archive.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::scene {

// Diagnostics and places in files, as caches and the responses of helper processes have them.

void put(ArchiveWriter& out, const SourceMark& mark);
void put(ArchiveWriter& out, const Diagnostic& diagnostic);

SourceMark take_mark(ArchiveReader& in);
/// Throws DamagedFile for a severity or a code that doesn't exist. Any text can be the message and the file.
Diagnostic take_diagnostic(ArchiveReader& in);

/// The size of a diagnostic of the shortest code with no message, bytes.
inline constexpr std::size_t kMinDiagnosticBytes = 40;

}  // namespace campuswalk::scene
