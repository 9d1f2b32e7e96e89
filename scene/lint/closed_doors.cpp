#include "scene/lint/closed_doors.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "scene/lint/named_parts.h"
#include "scene/model/line_triangle.h"
#include "scene/model/name_words.h"
#include "scene/model/upright_box.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kBehind = 0.8;            // metres that must be free before and behind a door
constexpr double kBeside = 0.4;            // metres within which a wall holds it
constexpr double kThickest = 0.4;          // metres, with its frame
constexpr double kPanel = 0.25;            // metres, the thickest without a name
constexpr std::size_t kMostPanels = 4000;  // the first of the file
constexpr std::size_t kMostNear = 20'000;  // triangles about one that is looked at
constexpr std::size_t kAtOnce = 128;       // panels in a pass over the model, to bound the memory
constexpr double kFloorBelow = 0.35;       // metres down to the floor

struct NearTriangle {
    std::array<Vector3d, 3> corners;
    bool own = false;  ///< of the panel itself
};

struct Panel {
    std::size_t node = 0;
    bool named = false;
    UprightBox box;
    Vector3d along;   ///< in its plane, level, unit
    Vector3d normal;  ///< level, unit
    double width = 0.0;
    double thickness = 0.0;
    Bounds surroundings;
    std::vector<NearTriangle> near;

    double bottom() const { return box.center.y() - 0.5 * box.size.y(); }
    Vector3d at(double beside, double above, double before) const {
        Vector3d p = box.center + beside * along + before * normal;
        p.y() = bottom() + above;
        return p;
    }
};

/// Whether the segment from `a` to `b` meets the triangle, edges included.
bool meets(const Vector3d& a, const Vector3d& b, const std::array<Vector3d, 3>& t) {
    const std::optional<double> fraction = line_through_triangle(t, a, b - a);
    return fraction && *fraction >= 0.0 && *fraction <= 1.0;
}

bool meets(const Panel& panel, const Vector3d& a, const Vector3d& b, bool own) {
    return std::ranges::any_of(panel.near,
                               [&](const NearTriangle& t) { return t.own == own && meets(a, b, t.corners); });
}

bool is_door_sized(const Panel& panel) {
    const double height = panel.box.size.y();
    if (panel.named) {
        return height >= 1.6 && height <= 6.0 && panel.width >= 0.5 && panel.width <= 8.0 &&
               panel.thickness <= kThickest;
    }
    return height >= 1.8 && height <= 2.6 && panel.width >= 0.6 && panel.width <= 2.6 &&
           panel.thickness <= kPanel;
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
    const double reach = 0.5 * panel.width + panel.thickness + kBehind;
    const Vector3d half(reach, 0.5 * size.y() + 1.0, reach);
    panel.surroundings = {panel.box.center - half, panel.box.center + half};
    return panel;
}

bool may_be_unnamed_panel(const Model& model, const Node& node) {
    constexpr std::size_t kMostTriangles = 2000;
    std::size_t triangles = 0;
    for (const MeshIndex index : node.meshes) {
        triangles += model.meshes[index_of(index)].triangles.size();
    }
    return triangles > 0 && triangles <= kMostTriangles;
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
    for (std::size_t n = 0; n < fits.size() && panels.size() < kMostPanels; ++n) {
        if (auto panel = panel_of(n, doors[n] == n, fits[n])) {
            panels.push_back(std::move(*panel));
        }
    }
    return panels;
}

/// Gives each panel the triangles about it, in one pass over the model.
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
                    const bool room = (*at)->near.size() <= kMostNear;
                    if (room && (low.array() <= box.max.array()).all() &&
                        (high.array() >= box.min.array()).all()) {
                        (*at)->near.push_back({{a, b, c}, (*at)->node == owner});
                    }
                }
            });
    }
}

/// Whether it fills its outline: of nine straight ways through it, at most two pass.
bool is_filled(const Panel& panel) {
    const double reach = 0.5 * panel.thickness + 0.05;
    int held = 0;
    for (const double beside : {-0.3, 0.017, 0.3}) {
        for (const double above : {0.3, 0.9, 1.5}) {
            const Vector3d front = panel.at(beside * panel.width, above, reach);
            const Vector3d back = panel.at(beside * panel.width, above, -reach);
            held += meets(panel, front, back, true) ? 1 : 0;
        }
    }
    return held >= 7;
}

/// Whether nothing else bars the way at the height of knees, hips and chest.
bool is_way_without_it(const Panel& panel) {
    const double reach = 0.5 * panel.thickness + kBehind;
    return std::ranges::none_of(std::array{0.5, 1.0, 1.5}, [&](double above) {
        return meets(panel, panel.at(0.0, above, reach), panel.at(0.0, above, -reach), false);
    });
}

/// An open leaf has one side in the air. What holds a closed one may lie at its front, with the leaf set
/// back, or at its back, and within its outline if that is of the frame, too.
bool is_between_walls(const Panel& panel) {
    const double edge = 0.5 * panel.width;
    const auto is_held = [&](double side, double above) {
        return std::ranges::any_of(std::array{-0.5, 0.0, 0.5}, [&](double depth) {
            const double before = depth * panel.thickness;
            return meets(panel, panel.at(side * 0.4 * edge, above, before),
                         panel.at(side * (edge + kBeside), above, before), false);
        });
    };
    return is_held(-1.0, 0.6) && is_held(-1.0, 1.4) && is_held(1.0, 0.6) && is_held(1.0, 1.4);
}

bool has_lintel_and_floor(const Panel& panel) {
    const double top = panel.box.size.y();
    const double before = 0.5 * panel.thickness + 0.3;
    return meets(panel, panel.at(0.0, top - 0.1, 0.0), panel.at(0.0, top + 2.0 * kBeside, 0.0), false) &&
           meets(panel, panel.at(0.0, 0.3, before), panel.at(0.0, -kFloorBelow, before), false) &&
           meets(panel, panel.at(0.0, 0.3, -before), panel.at(0.0, -kFloorBelow, -before), false);
}

bool is_closed_door(const Panel& panel) {
    const bool known = panel.near.size() <= kMostNear;
    return known && is_filled(panel) && is_way_without_it(panel) && is_between_walls(panel) &&
           (panel.named || has_lintel_and_floor(panel));
}

}  // namespace

std::vector<ClosedDoor> find_closed_doors(const Model& model) {
    const std::vector<std::size_t> doors = named_parts(model, is_door_name);
    std::vector<Panel> panels = find_panels(model, doors);
    std::vector<ClosedDoor> closed;
    for (std::size_t first = 0; first < panels.size(); first += kAtOnce) {
        const auto batch = std::span(panels).subspan(first, std::min(kAtOnce, panels.size() - first));
        gather_surroundings(model, doors, batch);
        for (Panel& panel : batch) {
            if (is_closed_door(panel)) {
                closed.push_back({panel.node, panel.at(0.0, 0.0, 0.0), panel.width, panel.box.size.y()});
            }
            panel.near = {};
        }
    }
    return closed;
}

}  // namespace campuswalk::scene
