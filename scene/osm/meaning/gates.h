#pragma once

#include <vector>

#include "scene/osm/ways/path_nodes.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// Whether a node or a way is a gate or another opening in a barrier.
bool is_gate(const Tags& tags);

/// Whether a gate lets no walkers through.
bool is_closed(const Tags& tags);

/// Of the angle between two unit directions, at least a third: gaps for paths that run along a barrier end.
double sine_between(const Point& a, const Point& b);

/// What a gate takes of its barrier: the part of its line as wide as the gate is tagged, or as the path that
/// leads through.
std::vector<Point> gate_opening(const MapWay& barrier, std::size_t place, const MapNode& gate,
                                const PathNode& path);
/// The same of a gate on no barrier: across the path.
std::vector<Point> gate_opening(const MapNode& gate, const PathNode& path);

/// The same of a gate that is drawn as a way: its line; of one drawn around, from end to end.
std::vector<Point> gate_opening(const MapWay& gate);

/// Its posts, and its leaf: across the opening if the gate is closed to walkers, else turned aside.
void add_gate(const ElementId& id, const Tags& tags, const std::vector<Point>& opening,
              const Terrain& terrain, ModelBuilder& model, Built& built);

}  // namespace campuswalk::scene::osm
