#pragma once

#include <vector>

#include "scene/base/diagnostic_archive.h"
#include "scene/osm/ways/campus_draft.h"

namespace campuswalk::scene::osm {

// What the map helper says about a campus, as plain data. A map may have taken the helper over, so what comes
// back is checked before files are made of it: names are ids, texts are UTF-8 without control characters and
// not longer than a map's, coordinates are those of a map, enumerations and counts are in their ranges. The
// functions that take throw DamagedFile for anything else.

/// Any finite number.
double take_finite(ArchiveReader& in);

void put_diagnostics(ArchiveWriter& out, const std::vector<Diagnostic>& diagnostics);
std::vector<Diagnostic> take_diagnostics(ArchiveReader& in);

void put_draft(ArchiveWriter& out, const CampusDraft& draft);
CampusDraft take_draft(ArchiveReader& in);

}  // namespace campuswalk::scene::osm
