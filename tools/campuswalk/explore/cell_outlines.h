#pragma once

#include <set>
#include <utility>
#include <vector>

namespace campuswalk::tools::explore {

/// A cell of side 1 with its lower left vertex there.
using UnitCell = std::pair<int, int>;

/// Vertices, the first one again at the end; only where the direction changes.
using Ring = std::vector<std::pair<int, int>>;

/// Cells that are joined by their sides: the outer ring counter-clockwise, then the holes, clockwise.
using CellPolygon = std::vector<Ring>;

/// One polygon for each set of joined cells, in the order of their first cells. Rings don't cross; they may
/// touch at a vertex.
std::vector<CellPolygon> outlines_of(const std::set<UnitCell>& cells);

}  // namespace campuswalk::tools::explore
