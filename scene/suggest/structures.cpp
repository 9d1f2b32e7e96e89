#include "scene/suggest/structures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include <Eigen/Geometry>

#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kVertical = 0.2;    // the largest |y| of a wall's unit normal
constexpr double kUpright = 0.005;   // that of one that somebody built
constexpr double kCell = 0.5;        // metres
constexpr double kLongest = 5000.0;  // metres; nothing longer is a wall of a building

Vector2d on_plan(const Vector3d& p) {
    return {p.x(), p.z()};
}

bool has_level_edge(const std::array<Vector3d, 3>& vertices) {
    constexpr double kLevel = 0.01;  // of its length
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector3d edge = vertices[(i + 1) % vertices.size()] - vertices[i];
        if (std::abs(edge.y()) < kLevel * edge.norm()) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<Wall> wall_of(const std::array<Vector3d, 3>& vertices) {
    const Vector3d normal = (vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]);
    const double area = 0.5 * normal.norm();
    if (!(area > 0.0) || std::abs(normal.y()) >= 2.0 * kVertical * area) {
        return std::nullopt;
    }
    Wall wall{.low = std::min({vertices[0].y(), vertices[1].y(), vertices[2].y()}),
              .high = std::max({vertices[0].y(), vertices[1].y(), vertices[2].y()}),
              .area = area,
              .is_built = std::abs(normal.y()) <= 2.0 * kUpright * area && has_level_edge(vertices)};
    double longest = -1.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector2d from = on_plan(vertices[i]);
        const Vector2d to = on_plan(vertices[(i + 1) % vertices.size()]);
        if ((to - from).squaredNorm() > longest) {
            longest = (to - from).squaredNorm();
            wall.from = from;
            wall.to = to;
        }
    }
    return wall;
}

WallSum sum_of(const std::vector<Wall>& walls) {
    WallSum sum;
    for (const Wall& wall : walls) {
        sum.bounds.extend({wall.from.x(), wall.low, wall.from.y()});
        sum.bounds.extend({wall.to.x(), wall.high, wall.to.y()});
        sum.area += wall.area;
        sum.built += wall.is_built ? wall.area : 0.0;
    }
    return sum;
}

namespace {

std::vector<Wall> walls_of(const Model& model, const Node& node) {
    std::vector<Wall> walls;
    for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        if (const std::optional<Wall> wall = wall_of({a, b, c})) {
            walls.push_back(*wall);
        }
    });
    return walls;
}

using Cell = std::pair<std::int32_t, std::int32_t>;

/// Each cell with those who have a wall in it; ascending.
using CellUsers = std::map<Cell, std::vector<std::size_t>>;

std::int32_t cell_number(double coordinate, double cell) {
    constexpr double kMost = 1e9;
    return static_cast<std::int32_t>(std::clamp(std::floor(coordinate / cell), -kMost, kMost));
}

/// So large that ten million cells are enough for all walls, whatever their unit.
double cell_for(const std::vector<Structure>& structures) {
    constexpr double kMostCells = 5e6;
    double length = 0.0;
    for (const Structure& structure : structures) {
        for (const Wall& wall : structure.walls) {
            length += std::min((wall.to - wall.from).norm(), kLongest);
        }
    }
    return std::max(kCell, length / kMostCells);
}

void add_walls(const Structure& structure, std::size_t index, double cell, CellUsers& users) {
    for (const Wall& wall : structure.walls) {
        const double length = (wall.to - wall.from).norm();
        if (!(length < kLongest)) {
            continue;
        }
        const int parts = 1 + static_cast<int>(length / (0.5 * cell));
        for (int i = 0; i <= parts; ++i) {
            const Vector2d p = wall.from + (static_cast<double>(i) / parts) * (wall.to - wall.from);
            std::vector<std::size_t>& here = users[{cell_number(p.x(), cell), cell_number(p.y(), cell)}];
            if (here.empty() || here.back() != index) {
                here.push_back(index);
            }
        }
    }
}

/// Names a group for what is in it only if no word of its name says otherwise: in "Main Street Campus" there
/// are houses.
bool holds_surroundings(const std::string& group) {
    const std::vector<std::string> words = words_of(group);
    return !words.empty() &&
           std::ranges::all_of(words, [](const std::string& word) { return is_surroundings_name(word); });
}

}  // namespace

std::vector<Structure> find_structures(const Model& model, const ModelReport& report) {
    std::vector<Structure> found;
    std::vector<bool> outside(model.nodes.size(), false);  // below a group of surroundings
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const Node& node = model.nodes[n];
        outside[n] = holds_surroundings(node.name) ||
                     (node.parent >= 0 && outside[static_cast<std::size_t>(node.parent)]);
        if (!outside[n] && report.nodes[n].triangles > 0 && !is_surroundings_name(node.name)) {
            found.push_back({n, walls_of(model, node)});
        }
    }
    return found;
}

std::vector<std::pair<std::size_t, std::size_t>> touching(const std::vector<Structure>& structures) {
    constexpr std::size_t kMostPairs = 8;
    constexpr std::array<Cell, 4> kNeighbours = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
    const double cell = cell_for(structures);
    CellUsers users;
    for (std::size_t i = 0; i < structures.size(); ++i) {
        add_walls(structures[i], i, cell, users);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    const auto add = [&](std::size_t a, std::size_t b) {
        if (a != b) {
            pairs.push_back(std::minmax(a, b));
        }
    };
    for (const auto& [at, here] : users) {
        for (std::size_t i = 0; i < here.size(); ++i) {
            const std::size_t last = here.size() <= kMostPairs ? here.size() : std::min(i + 2, here.size());
            for (std::size_t j = i + 1; j < last; ++j) {
                add(here[i], here[j]);
            }
        }
        for (const Cell& step : kNeighbours) {
            const auto there = users.find({at.first + step.first, at.second + step.second});
            if (there == users.end()) {
                continue;
            }
            const bool all = here.size() * there->second.size() <= kMostPairs * kMostPairs;
            for (std::size_t i = 0; i < (all ? here.size() : 1); ++i) {
                for (std::size_t j = 0; j < (all ? there->second.size() : 1); ++j) {
                    add(here[i], there->second[j]);
                }
            }
        }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace campuswalk::scene
