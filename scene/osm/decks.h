#pragma once

#include "scene/osm/bridges.h"
#include "scene/osm/compose.h"

namespace campuswalk::scene::osm {

/// The slab of a bridge in the plan, in parts whose tops are nearly planes.
struct DeckPart {
    const Path* path = nullptr;
    std::vector<Point> line;
    std::vector<double> heights;  ///< one per point of the line
    double width = 2.0;
    Polygons area;
};

/// The parts of a bridge: its paths, and from its open ends, where the ground couldn't rise enough, the paths
/// that lead on, down to the ground. Sets how much of steps is below it.
std::vector<DeckPart> deck_of(const Bridge& bridge, const PlanGeometry& geometry, const Terrain& terrain,
                              std::vector<Path>& paths, const SourceMark& mark, DiagnosticList& warnings);

/// The slab, and parapets where one would fall; nodes are called "bridge/way-123".
void add_deck(const std::vector<DeckPart>& parts, const Bridge& bridge, Composition& composition);

}  // namespace campuswalk::scene::osm
