#include "scene/campus/enclosing_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "collision/geometry/shapes.h"
#include "scene/campus/polygon_ears.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;
using Face = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr double kFlatRim = 0.01;              // of a rim's extent
constexpr std::size_t kMostRimVertices = 256;  // cutting ears takes the square of their number, or more
constexpr double kThickness = 1e-4;            // of the extent: a part that is thinner encloses nothing

double extent_of(const std::vector<Vector3d>& points) {
    collision::Aabb box;
    for (const Vector3d& p : points) {
        box.extend(p);
    }
    return points.empty() ? 0.0 : (box.max - box.min).norm();
}

/// For each position, the index of the first one within the tolerance.
std::vector<std::uint32_t> joined(const std::vector<Vector3d>& positions) {
    const double tolerance = std::min(1e-3, 1e-4 * extent_of(positions));
    const double cell = std::max(tolerance, 1e-9);
    std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells;
    const auto cell_of = [cell](const Vector3d& p) {
        const auto along = [cell](double x) { return static_cast<std::int64_t>(std::floor(x / cell)); };
        return std::array{along(p.x()), along(p.y()), along(p.z())};
    };
    const auto first_near = [&](std::uint32_t index) {
        const auto [x, y, z] = cell_of(positions[index]);
        std::uint32_t first = index;
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    const auto found = cells.find({x + dx, y + dy, z + dz});
                    if (found == cells.end()) {
                        continue;
                    }
                    for (const std::uint32_t other : found->second) {
                        if ((positions[other] - positions[index]).norm() <= tolerance) {
                            first = std::min(first, other);
                        }
                    }
                }
            }
        }
        return first;
    };
    std::vector<std::uint32_t> result(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        result[i] = first_near(i);
        if (result[i] == i) {
            cells[cell_of(positions[i])].push_back(i);
        }
    }
    return result;
}

/// The faces with their vertices joined, each once, without those that thereby lose their area.
std::vector<Face> distinct_faces(const WorldGeometry& geometry) {
    const std::vector<std::uint32_t> vertex = joined(geometry.positions);
    std::vector<Face> faces;
    std::set<Face> known;
    for (const auto& t : geometry.triangles) {
        const Face face = {vertex[t[0]], vertex[t[1]], vertex[t[2]]};
        Face key = face;
        std::ranges::sort(key);
        if (key[0] != key[1] && key[1] != key[2] && known.insert(key).second) {
            faces.push_back(face);
        }
    }
    return faces;
}

Edge directed(const Face& face, std::size_t side) {
    return {face[side], face[(side + 1) % 3]};
}

Edge undirected(const Edge& edge) {
    return {std::min(edge.first, edge.second), std::max(edge.first, edge.second)};
}

/// Whether a face runs along the edge from its lower to its higher vertex.
bool runs_up(const Face& face, const Edge& edge) {
    for (std::size_t side = 0; side < 3; ++side) {
        if (directed(face, side) == edge) {
            return true;
        }
    }
    return false;
}

/// Faces that are connected by edges of two faces, and face the same way if that is possible.
struct Part {
    std::vector<std::size_t> faces;
    std::vector<std::vector<std::uint32_t>>
        rims;  // of its openings, in the direction in which the edges of a lid have to run
    bool branching = false;
};

/// Divides the faces into parts, and turns those of a part so that they face the same way.
class Parts {
public:
    explicit Parts(std::vector<Face>& faces) : faces_(faces), seen_(faces.size(), false) {
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for (std::size_t side = 0; side < 3; ++side) {
                faces_at_[undirected(directed(faces[i], side))].push_back(i);
            }
        }
    }

    std::vector<Part> divide() {
        std::vector<Part> parts;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (!seen_[i]) {
                parts.push_back(part_from(i));
            }
        }
        return parts;
    }

private:
    Part part_from(std::size_t first) {
        Part part;
        seen_[first] = true;
        part.faces.push_back(first);
        for (std::size_t at = 0; at < part.faces.size(); ++at) {
            for (std::size_t side = 0; side < 3; ++side) {
                visit_neighbour(part.faces[at], side, part);
            }
        }
        find_rims(part);
        return part;
    }

    void visit_neighbour(std::size_t face, std::size_t side, Part& part) {
        const Edge edge = undirected(directed(faces_[face], side));
        const std::vector<std::size_t>& there = faces_at_[edge];
        if (there.size() != 2) {
            return;
        }
        const std::size_t other = there[0] == face ? there[1] : there[0];
        const bool same = runs_up(faces_[other], edge) != runs_up(faces_[face], edge);
        if (!seen_[other]) {
            seen_[other] = true;
            if (!same) {
                std::swap(faces_[other][1], faces_[other][2]);
            }
            part.faces.push_back(other);
        } else if (!same) {
            part.branching = true;  // a strip with one side
        }
    }

    /// Chains the edges that the part's faces run along more often in one direction than in the other.
    void find_rims(Part& part) {
        std::map<Edge, int> balance;
        for (const std::size_t face : part.faces) {
            for (std::size_t side = 0; side < 3; ++side) {
                const Edge edge = directed(faces_[face], side);
                balance[undirected(edge)] += edge.first < edge.second ? 1 : -1;
            }
        }
        std::multimap<std::uint32_t, std::uint32_t> next;
        for (const auto& [edge, more] : balance) {
            if (more == 0) {
                continue;
            }
            part.branching = part.branching || std::abs(more) > 1 || faces_at_[edge].size() > 1;
            more > 0 ? next.emplace(edge.second, edge.first) : next.emplace(edge.first, edge.second);
        }
        while (!part.branching && !next.empty()) {
            std::vector<std::uint32_t>& rim = part.rims.emplace_back();
            for (auto at = next.begin(); at != next.end(); at = next.find(rim.back())) {
                rim.push_back(at->second);
                next.erase(at);
            }
        }
    }

    std::vector<Face>& faces_;
    std::vector<bool> seen_;
    std::map<Edge, std::vector<std::size_t>> faces_at_;
};

/// Six times the volume, about a point near the part; negative if it faces inward.
double volume_of(const std::vector<Face>& faces, const std::vector<Vector3d>& positions) {
    double volume = 0.0;
    const Vector3d& about = positions[faces.front()[0]];
    for (const Face& f : faces) {
        volume += (positions[f[0]] - about).dot((positions[f[1]] - about).cross(positions[f[2]] - about));
    }
    return volume;
}

double area_of(const std::vector<Face>& faces, const std::vector<Vector3d>& positions) {
    double area = 0.0;
    for (const Face& f : faces) {
        area += 0.5 * (positions[f[1]] - positions[f[0]]).cross(positions[f[2]] - positions[f[0]]).norm();
    }
    return area;
}

/// The faces that close an opening; none if its rim isn't flat, or is longer than those of rooms.
std::vector<Face> lid_of(const std::vector<std::uint32_t>& rim, const std::vector<Vector3d>& positions) {
    if (rim.size() > kMostRimVertices) {
        return {};
    }
    std::vector<Vector3d> points;
    for (const std::uint32_t vertex : rim) {
        points.push_back(positions[vertex]);
    }
    const Vector3d centre = std::accumulate(points.begin(), points.end(), Vector3d(Vector3d::Zero())) /
                            static_cast<double>(points.size());
    Vector3d normal = Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        normal += (points[i] - centre).cross(points[(i + 1) % points.size()] - centre);
    }
    normal.normalize();
    const double most = kFlatRim * extent_of(points);
    if (std::ranges::any_of(points,
                            [&](const Vector3d& p) { return std::abs(normal.dot(p - centre)) > most; })) {
        return {};
    }
    std::vector<Face> lid;
    for (const auto& ear : polygon_ears(points, normal)) {
        lid.push_back({rim[ear[0]], rim[ear[1]], rim[ear[2]]});
    }
    return lid;
}

/// Closes the parts that can be closed, turns them outward, and counts the others.
class Closer {
public:
    Closer(const WorldGeometry& geometry, std::vector<Face> faces)
        : positions_(geometry.positions), faces_(std::move(faces)) {
        surface_.geometry.positions = geometry.positions;
    }

    EnclosingSurface run() {
        for (const Part& part : Parts(faces_).divide()) {
            add(part);
        }
        if (enclosing_ >= largest_left_out_) {
            surface_.no_inside.reset();
        }
        return std::move(surface_);
    }

private:
    void add(const Part& part) {
        std::vector<Face> closed;
        for (const std::size_t face : part.faces) {
            closed.push_back(faces_[face]);
        }
        bool is_closed = !part.branching;
        for (const std::vector<std::uint32_t>& rim : part.rims) {
            const std::vector<Face> lid = lid_of(rim, positions_);
            is_closed = is_closed && !lid.empty();
            closed.insert(closed.end(), lid.begin(), lid.end());
        }
        const double area = area_of(closed, positions_);
        const double volume = volume_of(closed, positions_);
        // A body of this surface is as thick as its volume over half of it.
        const bool is_flat = std::abs(volume) / 6.0 <= kThickness * 0.5 * area * std::sqrt(area);
        if (is_closed && !is_flat) {
            enclosing_ = std::max(enclosing_, area);
            surface_.openings += part.rims.size();
            if (volume < 0.0) {
                for (Face& face : closed) {
                    std::swap(face[1], face[2]);
                }
            }
            surface_.geometry.triangles.insert(surface_.geometry.triangles.end(), closed.begin(),
                                               closed.end());
            return;
        }
        surface_.left_out += part.faces.size();
        if (area > largest_left_out_) {
            largest_left_out_ = area;
            surface_.no_inside = part.branching ? NoInside::branching
                                 : is_closed    ? NoInside::flat
                                                : NoInside::open;
        }
    }

    const std::vector<Vector3d>& positions_;
    std::vector<Face> faces_;
    EnclosingSurface surface_;
    double enclosing_ = 0.0;  // square metres of the largest part that encloses something
    double largest_left_out_ = -1.0;
};

}  // namespace

EnclosingSurface enclosing_surface(const WorldGeometry& geometry) {
    if (geometry.triangles.size() > kMostClosedFaces) {
        return {.no_inside = NoInside::too_large};
    }
    return Closer(geometry, distinct_faces(geometry)).run();
}

}  // namespace campuswalk::scene
