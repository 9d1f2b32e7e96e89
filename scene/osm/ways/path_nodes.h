#pragma once

#include <cstdint>
#include <unordered_map>

#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// A node of a path: which way that runs, and how wide it is there.
struct PathNode {
    const Path* path = nullptr;
    Point along = Point(0, 1);  ///< unit
};

/// By node, the first path that has it. Paths under the ground are left out.
std::unordered_map<std::int64_t, PathNode> path_nodes(const std::vector<Path>& paths);

/// Unit direction of a line at one of its points.
Point direction_at(const std::vector<Point>& line, std::size_t i);

}  // namespace campuswalk::scene::osm
