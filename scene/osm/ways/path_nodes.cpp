#include "scene/osm/ways/path_nodes.h"

namespace campuswalk::scene::osm {

Point direction_at(const std::vector<Point>& line, std::size_t i) {
    const Point d = i + 1 < line.size() ? Point(line[i + 1] - line[i]) : Point(line[i] - line[i - 1]);
    const double length = norm(d);
    return length > 0.0 ? Point(d / length) : Point(0, 1);
}

std::unordered_map<std::int64_t, PathNode> path_nodes(const std::vector<Path>& paths) {
    std::unordered_map<std::int64_t, PathNode> nodes;
    for (const Path& path : paths) {
        for (std::size_t i = 0; path.on_ground() && i < path.way->nodes.size(); ++i) {
            nodes.try_emplace(path.way->nodes[i], PathNode{&path, direction_at(path.way->points, i)});
        }
    }
    return nodes;
}

}  // namespace campuswalk::scene::osm
