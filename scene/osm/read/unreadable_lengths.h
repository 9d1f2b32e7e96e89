#pragma once

#include "scene/base/diagnostic.h"
#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

/// Warns of heights and widths that are tagged in a way that length_of() doesn't read (`unreadable-length`):
/// what they are of becomes as high or wide as is usual.
void report_unreadable_lengths(const Map& map, const SourceMark& mark, DiagnosticList& warnings);

}  // namespace campuswalk::scene::osm
