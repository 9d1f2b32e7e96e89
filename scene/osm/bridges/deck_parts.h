#pragma once

#include <cstddef>
#include <vector>

#include "scene/osm/bridges/bridges.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// A part of a bridge's slab in the plan whose top is nearly a plane.
struct DeckPart {
    const Path* path = nullptr;
    std::vector<Point> line;
    std::vector<double> heights;  ///< one per point of the line
    double width = 2.0;
    Polygons area;

    /// Of the line, metres.
    double height(const Point& p) const { return height_along(line, heights, p); }
};

/// How much of steps is below a deck, at their first or their last node.
struct StairsTrim {
    std::size_t path = 0;
    bool first = false;
    double length = 0.0;  ///< metres
};

struct Deck {
    const Bridge* bridge = nullptr;
    std::vector<DeckPart> parts;
    std::vector<StairsTrim> trims;
};

/// The parts of a bridge: its paths, from its open ends, where the ground couldn't rise enough, the paths
/// that lead on, down to the ground, and what its outlines have beside them; all of it only where the map has
/// ground.
Deck deck_of(const Bridge& bridge, const Site& site);

}  // namespace campuswalk::scene::osm
