#include "scene/lint/closed_doors.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "scene/model/line_triangle.h"
#include "scene/model/name_words.h"
#include "scene/model/named_parts.h"
#include "scene/model/upright_box.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kClearance = 0.8;             // metres that must be free on both sides of a door
constexpr double kWallGap = 0.4;               // metres within which a wall must be beside it
constexpr double kMaxThickness = 0.4;          // metres, of a named door, which may include the frame
constexpr double kMaxUnnamedThickness = 0.25;  // metres
constexpr double kMaxFloorGap = 0.35;          // metres from the panel down to the floor
constexpr std::size_t kMaxPanels = 4000;       // bounds the time; later ones are ignored
constexpr std::size_t kMaxNearby = 20'000;     // triangles around a panel; with more it is ignored
constexpr std::size_t kBatchSize = 128;        // panels per pass over the model; bounds the memory

struct NearbyTriangle {
    std::array<Vector3d, 3> vertices;
    bool own = false;  ///< belongs to the panel itself
};

struct Panel {
    std::size_t node = 0;
    bool named = false;
    UprightBox box;
    Vector3d along;   ///< in its plane, horizontal, unit
    Vector3d normal;  ///< horizontal, unit
    double width = 0.0;
    double thickness = 0.0;
    Bounds surroundings;
    std::vector<NearbyTriangle> nearby;

    double bottom() const { return box.center.y() - 0.5 * box.size.y(); }
    Vector3d at(double beside, double above, double before) const {
        Vector3d p = box.center + beside * along + before * normal;
        p.y() = bottom() + above;
        return p;
    }
};

/// Whether the segment from `a` to `b` intersects the triangle, edges included.
bool intersects(const Vector3d& a, const Vector3d& b, const std::array<Vector3d, 3>& t) {
    const std::optional<double> fraction = line_through_triangle(t, a, b - a);
    return fraction && *fraction >= 0.0 && *fraction <= 1.0;
}

/// Whether it intersects the panel itself (`own`) or anything else nearby.
bool intersects(const Panel& panel, const Vector3d& a, const Vector3d& b, bool own) {
    return std::ranges::any_of(
        panel.nearby, [&](const NearbyTriangle& t) { return t.own == own && intersects(a, b, t.vertices); });
}

bool is_door_sized(const Panel& panel) {
    const double height = panel.box.size.y();
    if (panel.named) {
        return height >= 1.6 && height <= 6.0 && panel.width >= 0.5 && panel.width <= 8.0 &&
               panel.thickness <= kMaxThickness;
    }
    return height >= 1.8 && height <= 2.6 && panel.width >= 0.6 && panel.width <= 2.6 &&
           panel.thickness <= kMaxUnnamedThickness;
}

std::optional<Panel> panel_of(std::size_t node, bool named, UprightBoxFit& fit) {
    if (fit.empty()) {
        return std::nullopt;
    }
    Panel panel;
    panel.node = node;
    panel.named = named;
    panel.box = fit.box();
    const Vector3d& size = panel.box.size;
    const bool wide = size.x() >= size.z();
    panel.along = wide ? panel.box.along : panel.box.across();
    panel.normal = wide ? panel.box.across() : panel.box.along;
    panel.width = std::max(size.x(), size.z());
    panel.thickness = std::min(size.x(), size.z());
    if (!is_door_sized(panel)) {
        return std::nullopt;
    }
    const double reach = 0.5 * panel.width + panel.thickness + kClearance;
    const Vector3d half(reach, 0.5 * size.y() + 1.0, reach);
    panel.surroundings = {panel.box.center - half, panel.box.center + half};
    return panel;
}

bool may_be_unnamed_panel(const Model& model, const Node& node) {
    constexpr std::size_t kMaxTriangles = 2000;
    std::size_t triangles = 0;
    for (const MeshIndex index : node.meshes) {
        triangles += model.meshes[index_of(index)].triangles.size();
    }
    return triangles > 0 && triangles <= kMaxTriangles;
}

std::vector<Panel> find_panels(const Model& model, const std::vector<std::size_t>& doors) {
    std::vector<UprightBoxFit> fits(model.nodes.size());
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const std::size_t door = doors[n] == kNoPart ? n : doors[n];
        if (doors[n] != kNoPart || may_be_unnamed_panel(model, model.nodes[n])) {
            for_each_vertex(model, model.nodes[n], [&](const Vector3d& p) { fits[door].add(p); });
        }
    }
    std::vector<Panel> panels;
    for (std::size_t n = 0; n < fits.size() && panels.size() < kMaxPanels; ++n) {
        if (auto panel = panel_of(n, doors[n] == n, fits[n])) {
            panels.push_back(std::move(*panel));
        }
    }
    return panels;
}

/// Collects the triangles around each panel, in one pass over the model: sweep along x.
void gather_surroundings(const Model& model, const std::vector<std::size_t>& doors, std::span<Panel> panels) {
    std::vector<Panel*> by_x;
    double widest = 0.0;
    for (Panel& panel : panels) {
        by_x.push_back(&panel);
        widest = std::max(widest, panel.surroundings.max.x() - panel.surroundings.min.x());
    }
    std::stable_sort(by_x.begin(), by_x.end(), [](const Panel* a, const Panel* b) {
        return a->surroundings.min.x() < b->surroundings.min.x();
    });
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const std::size_t owner = doors[n] == kNoPart ? n : doors[n];
        for_each_triangle(
            model, model.nodes[n], [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                const Vector3d low = a.cwiseMin(b).cwiseMin(c);
                const Vector3d high = a.cwiseMax(b).cwiseMax(c);
                auto at =
                    std::lower_bound(by_x.begin(), by_x.end(), low.x() - widest,
                                     [](const Panel* p, double x) { return p->surroundings.min.x() < x; });
                for (; at != by_x.end() && (*at)->surroundings.min.x() <= high.x(); ++at) {
                    const Bounds& box = (*at)->surroundings;
                    const bool has_capacity = (*at)->nearby.size() <= kMaxNearby;
                    if (has_capacity && (low.array() <= box.max.array()).all() &&
                        (high.array() >= box.min.array()).all()) {
                        (*at)->nearby.push_back({{a, b, c}, (*at)->node == owner});
                    }
                }
            });
    }
}

/// Whether it has no large holes: at most two of nine segments through it miss.
bool is_filled(const Panel& panel) {
    const double reach = 0.5 * panel.thickness + 0.05;
    int hits = 0;
    for (const double beside : {-0.3, 0.017, 0.3}) {
        for (const double above : {0.3, 0.9, 1.5}) {
            const Vector3d front = panel.at(beside * panel.width, above, reach);
            const Vector3d back = panel.at(beside * panel.width, above, -reach);
            hits += intersects(panel, front, back, true) ? 1 : 0;
        }
    }
    return hits >= 7;
}

/// Whether nothing else blocks the doorway at the height of knees, hips and chest.
bool is_passable_without(const Panel& panel) {
    const double reach = 0.5 * panel.thickness + kClearance;
    return std::ranges::none_of(std::array{0.5, 1.0, 1.5}, [&](double above) {
        return intersects(panel, panel.at(0.0, above, reach), panel.at(0.0, above, -reach), false);
    });
}

/// An open door has a wall on one side at most. The wall beside a closed one may be flush with its front, its
/// middle or its back, and may begin within the panel's box if that includes the frame.
bool is_between_walls(const Panel& panel) {
    const double edge = 0.5 * panel.width;
    const auto has_wall = [&](double side, double above) {
        return std::ranges::any_of(std::array{-0.5, 0.0, 0.5}, [&](double depth) {
            const double before = depth * panel.thickness;
            return intersects(panel, panel.at(side * 0.4 * edge, above, before),
                              panel.at(side * (edge + kWallGap), above, before), false);
        });
    };
    return has_wall(-1.0, 0.6) && has_wall(-1.0, 1.4) && has_wall(1.0, 0.6) && has_wall(1.0, 1.4);
}

bool has_lintel_and_floor(const Panel& panel) {
    const double top = panel.box.size.y();
    const double before = 0.5 * panel.thickness + 0.3;
    return intersects(panel, panel.at(0.0, top - 0.1, 0.0), panel.at(0.0, top + 2.0 * kWallGap, 0.0),
                      false) &&
           intersects(panel, panel.at(0.0, 0.3, before), panel.at(0.0, -kMaxFloorGap, before), false) &&
           intersects(panel, panel.at(0.0, 0.3, -before), panel.at(0.0, -kMaxFloorGap, -before), false);
}

bool is_closed_door(const Panel& panel) {
    const bool complete = panel.nearby.size() <= kMaxNearby;
    return complete && is_filled(panel) && is_passable_without(panel) && is_between_walls(panel) &&
           (panel.named || has_lintel_and_floor(panel));
}

}  // namespace

std::vector<ClosedDoor> find_closed_doors(const Model& model) {
    const std::vector<std::size_t> doors = named_parts(model, is_door_name);
    std::vector<Panel> panels = find_panels(model, doors);
    std::vector<ClosedDoor> closed;
    for (std::size_t first = 0; first < panels.size(); first += kBatchSize) {
        const auto batch = std::span(panels).subspan(first, std::min(kBatchSize, panels.size() - first));
        gather_surroundings(model, doors, batch);
        for (Panel& panel : batch) {
            if (is_closed_door(panel)) {
                closed.push_back({panel.node, panel.at(0.0, 0.0, 0.0), panel.width, panel.box.size.y()});
            }
            panel.nearby = {};
        }
    }
    return closed;
}

}  // namespace campuswalk::scene
