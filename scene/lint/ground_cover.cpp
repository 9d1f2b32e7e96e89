#include "scene/lint/ground_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kMinCell = 0.2;  // metres
constexpr double kMaxCells = 160e3;
constexpr double kMaxCellTests = 5e6;  // by all triangles; overlapping layers get larger cells
constexpr double kEdgeDistance = 0.4;  // metres, half an avatar's width and some
constexpr double kStep = 0.3;          // metres
constexpr double kMinNormalY = 0.643;  // cosine of 50 degrees, the steepest slope that avatars walk
constexpr double kMaxGradient = 1.19;  // its tangent
constexpr double kHeadroom = 1.8;      // metres

/// A walkable surface at the centre of a cell.
struct Floor {
    std::int64_t cell = 0;
    double height = 0.0;
    bool faces_up = false;
};

/// A layered height field: a grid over the footprint with any number of floors per cell.
class HeightField {
public:
    HeightField(const Model& model, const Bounds& bounds) : bounds_(bounds) {
        const Vector3d size = bounds.max - bounds.min;
        cell_ = std::max(kMinCell, std::sqrt(size.x() * size.z() / kMaxCells));
        cell_ = std::max(cell_, std::max(size.x(), size.z()) / kMaxCells);
        cell_ = std::max(cell_, std::sqrt(area_of_boxes(model) / kMaxCellTests));
        width_ = static_cast<std::int64_t>(size.x() / cell_) + 1;
        depth_ = static_cast<std::int64_t>(size.z() / cell_) + 1;
        covered_.assign(static_cast<std::size_t>(width_ * depth_), false);
        for (const Node& node : model.nodes) {
            for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                rasterize(a, b, c);
            });
        }
        sort_floors();
    }

    double cell() const { return cell_; }
    std::int64_t count_covered() const { return std::count(covered_.begin(), covered_.end(), true); }
    const std::vector<Floor>& floors() const { return floors_; }

    /// The index of the floor nearest in height in the cell at offset `x`, `z`; -1 if none is within `reach`.
    std::int64_t neighbour(const Floor& floor, std::int64_t x, std::int64_t z, double reach) const {
        const std::int64_t to_x = floor.cell % width_ + x;
        const std::int64_t to_z = floor.cell / width_ + z;
        if (to_x < 0 || to_z < 0 || to_x >= width_ || to_z >= depth_) {
            return -1;
        }
        const auto cell = static_cast<std::size_t>(to_z * width_ + to_x);
        const auto first = floors_.begin() + first_floor_[cell];
        const auto last = floors_.begin() + first_floor_[cell + 1];
        const auto above = std::lower_bound(first, last, floor.height,
                                            [](const Floor& f, double height) { return f.height < height; });
        auto best = last;
        if (above != last && above->height - floor.height <= reach) {
            best = above;
            reach = above->height - floor.height;
        }
        if (above != first && floor.height - std::prev(above)->height <= reach) {
            best = std::prev(above);
        }
        return best == last ? -1 : best - floors_.begin();
    }

private:
    /// The sum of the areas of the triangles' bounding boxes seen from above.
    static double area_of_boxes(const Model& model) {
        double area = 0.0;
        for (const Node& node : model.nodes) {
            for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                const Vector3d size = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
                area += size.x() * size.z();
            });
        }
        return area;
    }

    void rasterize(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        const Vector3d normal = (b - a).cross(c - a);
        if (normal.y() == 0.0) {
            return;
        }
        const bool walkable = std::abs(normal.y()) >= kMinNormalY * normal.norm();
        const Vector3d low = a.cwiseMin(b).cwiseMin(c) - bounds_.min;
        const Vector3d high = a.cwiseMax(b).cwiseMax(c) - bounds_.min;
        const auto first_x = static_cast<std::int64_t>(std::ceil(low.x() / cell_ - 0.5));
        const auto first_z = static_cast<std::int64_t>(std::ceil(low.z() / cell_ - 0.5));
        const auto inside = [&](const Vector3d& from, const Vector3d& to, double x, double z) {
            const double turn = (to.x() - from.x()) * (z - from.z()) - (to.z() - from.z()) * (x - from.x());
            return normal.y() > 0.0 ? turn <= 0.0 : turn >= 0.0;
        };
        for (std::int64_t j = std::max<std::int64_t>(first_z, 0); j < depth_; ++j) {
            const double z = bounds_.min.z() + (static_cast<double>(j) + 0.5) * cell_;
            if (z - bounds_.min.z() > high.z()) {
                break;
            }
            for (std::int64_t i = std::max<std::int64_t>(first_x, 0); i < width_; ++i) {
                const double x = bounds_.min.x() + (static_cast<double>(i) + 0.5) * cell_;
                if (x - bounds_.min.x() > high.x()) {
                    break;
                }
                if (inside(a, b, x, z) && inside(b, c, x, z) && inside(c, a, x, z)) {
                    const std::int64_t cell = j * width_ + i;
                    covered_[static_cast<std::size_t>(cell)] = true;
                    const double up = normal.x() * (x - a.x()) + normal.z() * (z - a.z());
                    if (walkable) {
                        floors_.push_back({cell, a.y() - up / normal.y(), normal.y() > 0.0});
                    }
                }
            }
        }
    }

    void sort_floors() {
        std::sort(floors_.begin(), floors_.end(), [](const Floor& a, const Floor& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.height < b.height;
        });
        std::vector<Floor> with_headroom;
        for (std::size_t f = 0; f < floors_.size(); ++f) {
            const Floor& floor = floors_[f];
            const bool top = f + 1 == floors_.size() || floors_[f + 1].cell != floor.cell;
            const bool headroom = top || floors_[f + 1].height - floor.height >= kHeadroom;
            // A face that points down right below one that points up is the bottom of a solid. Others that
            // point down may be floors modelled inside out.
            const bool bottom = !top && !floor.faces_up && floors_[f + 1].faces_up;
            if (headroom && !bottom) {
                with_headroom.push_back(floor);
            }
        }
        floors_.swap(with_headroom);
        first_floor_.assign(covered_.size() + 1, 0);
        for (const Floor& floor : floors_) {
            ++first_floor_[static_cast<std::size_t>(floor.cell) + 1];
        }
        std::partial_sum(first_floor_.begin(), first_floor_.end(), first_floor_.begin());
    }

    Bounds bounds_;
    double cell_ = kMinCell;
    std::int64_t width_ = 0;
    std::int64_t depth_ = 0;
    std::vector<bool> covered_;
    std::vector<Floor> floors_;
    std::vector<std::int64_t> first_floor_;  ///< by cell, and one past the end
};

constexpr std::array<std::array<std::int64_t, 2>, 4> kDirections = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// By floor: whether there is floor at kEdgeDistance in all four directions.
std::vector<bool> away_from_edges(const HeightField& field) {
    const auto far = static_cast<std::int64_t>(std::ceil(kEdgeDistance / field.cell()));
    const double reach = kStep + kMaxGradient * static_cast<double>(far) * field.cell();
    std::vector<bool> result;
    for (const Floor& floor : field.floors()) {
        result.push_back(std::ranges::all_of(kDirections, [&](const std::array<std::int64_t, 2>& direction) {
            return field.neighbour(floor, far * direction[0], far * direction[1], reach) >= 0;
        }));
    }
    return result;
}

struct Region {
    std::size_t cells = 0;  ///< a cell with several floors counts once
    std::vector<double> heights;
};

/// The connected region that covers most cells.
Region largest_region(const HeightField& field) {
    const double reach = kStep + kMaxGradient * field.cell();
    std::vector<bool> open = away_from_edges(field);
    Region largest;
    std::vector<std::size_t> stack;
    for (std::size_t first = 0; first < open.size(); ++first) {
        if (!open[first]) {
            continue;
        }
        Region region;
        std::vector<std::int64_t> cells;
        open[first] = false;
        stack = {first};
        while (!stack.empty()) {
            const Floor& floor = field.floors()[stack.back()];
            stack.pop_back();
            region.heights.push_back(floor.height);
            cells.push_back(floor.cell);
            for (const auto& direction : kDirections) {
                const std::int64_t next = field.neighbour(floor, direction[0], direction[1], reach);
                if (next >= 0 && open[static_cast<std::size_t>(next)]) {
                    open[static_cast<std::size_t>(next)] = false;
                    stack.push_back(static_cast<std::size_t>(next));
                }
            }
        }
        std::sort(cells.begin(), cells.end());
        region.cells = static_cast<std::size_t>(std::unique(cells.begin(), cells.end()) - cells.begin());
        if (region.cells > largest.cells) {
            largest = std::move(region);
        }
    }
    return largest;
}

double share_of_area_below(const Model& model, double height) {
    double below = 0.0;
    double all = 0.0;
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
            const double area = (b - a).cross(c - a).norm();
            all += area;
            below += (a.y() + b.y() + c.y()) / 3.0 < height ? area : 0.0;
        });
    }
    return all > 0.0 ? below / all : 0.0;
}

}  // namespace

GroundCover measure_ground(const Model& model, const Bounds& bounds) {
    const HeightField field(model, bounds);
    Region region = largest_region(field);
    std::vector<double>& heights = region.heights;
    if (heights.empty()) {
        return {};
    }
    const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
    std::nth_element(heights.begin(), low, heights.end());
    constexpr double kDrop = 1.0;  // metres
    return {static_cast<double>(region.cells) / static_cast<double>(field.count_covered()), *low,
            share_of_area_below(model, *low - kDrop)};
}

bool lacks_ground(const GroundCover& cover) {
    constexpr double kMinShare = 0.25;
    constexpr double kMaxShareBelow = 0.3;
    return cover.share < kMinShare || cover.share_below > kMaxShareBelow;
}

}  // namespace campuswalk::scene
