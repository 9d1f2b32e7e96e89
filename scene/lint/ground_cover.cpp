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

constexpr double kLeastSquare = 0.2;    // metres
constexpr double kMostSquares = 160e3;  // of the plan
constexpr double kMostLooks = 5e6;      // at squares, by all triangles: sheets on sheets get larger ones
constexpr double kShoulder = 0.4;       // metres from an edge
constexpr double kStep = 0.3;           // metres
constexpr double kLevel = 0.643;        // cosine of 50 degrees, the steepest that avatars walk
constexpr double kSlope = 1.19;         // its tangent
constexpr double kHeadroom = 1.8;       // metres

struct Floor {
    std::int64_t square = 0;
    double height = 0.0;
    bool faces_up = false;
};

/// Squares of the plan, and the level faces over their middles.
class Plan {
public:
    Plan(const Model& model, const Bounds& bounds) : bounds_(bounds) {
        const Vector3d size = bounds.max - bounds.min;
        square_ = std::max(kLeastSquare, std::sqrt(size.x() * size.z() / kMostSquares));
        square_ = std::max(square_, std::max(size.x(), size.z()) / kMostSquares);
        square_ = std::max(square_, std::sqrt(ground_of_boxes(model) / kMostLooks));
        width_ = static_cast<std::int64_t>(size.x() / square_) + 1;
        depth_ = static_cast<std::int64_t>(size.z() / square_) + 1;
        covered_.assign(static_cast<std::size_t>(width_ * depth_), false);
        for (const Node& node : model.nodes) {
            for_each_triangle(model, node,
                              [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) { add(a, b, c); });
        }
        sort_floors();
    }

    double square() const { return square_; }
    std::int64_t count_covered() const { return std::count(covered_.begin(), covered_.end(), true); }
    const std::vector<Floor>& floors() const { return floors_; }

    /// The floor `x`, `z` squares farther that is nearest in height, if it is within `reach`; else -1.
    std::int64_t neighbour(const Floor& floor, std::int64_t x, std::int64_t z, double reach) const {
        const std::int64_t to_x = floor.square % width_ + x;
        const std::int64_t to_z = floor.square / width_ + z;
        if (to_x < 0 || to_z < 0 || to_x >= width_ || to_z >= depth_) {
            return -1;
        }
        const auto square = static_cast<std::size_t>(to_z * width_ + to_x);
        const auto first = floors_.begin() + first_floor_[square];
        const auto last = floors_.begin() + first_floor_[square + 1];
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
    /// The sum of what the triangles' boxes cover of the plan.
    static double ground_of_boxes(const Model& model) {
        double ground = 0.0;
        for (const Node& node : model.nodes) {
            for_each_triangle(model, node, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                const Vector3d size = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
                ground += size.x() * size.z();
            });
        }
        return ground;
    }

    void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        const Vector3d normal = (b - a).cross(c - a);
        if (normal.y() == 0.0) {
            return;
        }
        const bool level = std::abs(normal.y()) >= kLevel * normal.norm();
        const Vector3d low = a.cwiseMin(b).cwiseMin(c) - bounds_.min;
        const Vector3d high = a.cwiseMax(b).cwiseMax(c) - bounds_.min;
        const auto first_x = static_cast<std::int64_t>(std::ceil(low.x() / square_ - 0.5));
        const auto first_z = static_cast<std::int64_t>(std::ceil(low.z() / square_ - 0.5));
        const auto inside = [&](const Vector3d& from, const Vector3d& to, double x, double z) {
            const double turn = (to.x() - from.x()) * (z - from.z()) - (to.z() - from.z()) * (x - from.x());
            return normal.y() > 0.0 ? turn <= 0.0 : turn >= 0.0;
        };
        for (std::int64_t j = std::max<std::int64_t>(first_z, 0); j < depth_; ++j) {
            const double z = bounds_.min.z() + (static_cast<double>(j) + 0.5) * square_;
            if (z - bounds_.min.z() > high.z()) {
                break;
            }
            for (std::int64_t i = std::max<std::int64_t>(first_x, 0); i < width_; ++i) {
                const double x = bounds_.min.x() + (static_cast<double>(i) + 0.5) * square_;
                if (x - bounds_.min.x() > high.x()) {
                    break;
                }
                if (inside(a, b, x, z) && inside(b, c, x, z) && inside(c, a, x, z)) {
                    const std::int64_t square = j * width_ + i;
                    covered_[static_cast<std::size_t>(square)] = true;
                    const double up = normal.x() * (x - a.x()) + normal.z() * (z - a.z());
                    if (level) {
                        floors_.push_back({square, a.y() - up / normal.y(), normal.y() > 0.0});
                    }
                }
            }
        }
    }

    void sort_floors() {
        std::sort(floors_.begin(), floors_.end(), [](const Floor& a, const Floor& b) {
            return a.square != b.square ? a.square < b.square : a.height < b.height;
        });
        std::vector<Floor> with_headroom;
        for (std::size_t f = 0; f < floors_.size(); ++f) {
            const Floor& floor = floors_[f];
            const bool top = f + 1 == floors_.size() || floors_[f + 1].square != floor.square;
            const bool headroom = top || floors_[f + 1].height - floor.height >= kHeadroom;
            // A face that looks down below one that looks up is a solid's bottom. Others may be floors that
            // were modelled inside out.
            const bool bottom = !top && !floor.faces_up && floors_[f + 1].faces_up;
            if (headroom && !bottom) {
                with_headroom.push_back(floor);
            }
        }
        floors_.swap(with_headroom);
        first_floor_.assign(covered_.size() + 1, 0);
        for (const Floor& floor : floors_) {
            ++first_floor_[static_cast<std::size_t>(floor.square) + 1];
        }
        std::partial_sum(first_floor_.begin(), first_floor_.end(), first_floor_.begin());
    }

    Bounds bounds_;
    double square_ = kLeastSquare;
    std::int64_t width_ = 0;
    std::int64_t depth_ = 0;
    std::vector<bool> covered_;
    std::vector<Floor> floors_;
    std::vector<std::int64_t> first_floor_;  ///< by square, with one more at the end
};

constexpr std::array<std::array<std::int64_t, 2>, 4> kWays = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Those from which a shoulder's breadth in the four directions is floor, too.
std::vector<bool> with_room(const Plan& plan) {
    const auto far = static_cast<std::int64_t>(std::ceil(kShoulder / plan.square()));
    const double reach = kStep + kSlope * static_cast<double>(far) * plan.square();
    std::vector<bool> roomy;
    for (const Floor& floor : plan.floors()) {
        roomy.push_back(std::ranges::all_of(kWays, [&](const std::array<std::int64_t, 2>& way) {
            return plan.neighbour(floor, far * way[0], far * way[1], reach) >= 0;
        }));
    }
    return roomy;
}

struct Part {
    std::size_t squares = 0;  ///< one above the other counted once
    std::vector<double> heights;
};

/// The connected part that covers most of the plan.
Part largest_part(const Plan& plan) {
    const double reach = kStep + kSlope * plan.square();
    std::vector<bool> open = with_room(plan);
    Part largest;
    std::vector<std::size_t> waiting;
    for (std::size_t first = 0; first < open.size(); ++first) {
        if (!open[first]) {
            continue;
        }
        Part part;
        std::vector<std::int64_t> squares;
        open[first] = false;
        waiting = {first};
        while (!waiting.empty()) {
            const Floor& floor = plan.floors()[waiting.back()];
            waiting.pop_back();
            part.heights.push_back(floor.height);
            squares.push_back(floor.square);
            for (const auto& way : kWays) {
                const std::int64_t next = plan.neighbour(floor, way[0], way[1], reach);
                if (next >= 0 && open[static_cast<std::size_t>(next)]) {
                    open[static_cast<std::size_t>(next)] = false;
                    waiting.push_back(static_cast<std::size_t>(next));
                }
            }
        }
        std::sort(squares.begin(), squares.end());
        part.squares =
            static_cast<std::size_t>(std::unique(squares.begin(), squares.end()) - squares.begin());
        if (part.squares > largest.squares) {
            largest = std::move(part);
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
    const Plan plan(model, bounds);
    Part part = largest_part(plan);
    std::vector<double>& heights = part.heights;
    if (heights.empty()) {
        return {};
    }
    const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
    std::nth_element(heights.begin(), low, heights.end());
    constexpr double kBelow = 1.0;  // metres
    return {static_cast<double>(part.squares) / static_cast<double>(plan.count_covered()), *low,
            share_of_area_below(model, *low - kBelow)};
}

bool lacks_ground(const GroundCover& cover) {
    constexpr double kLeastShare = 0.25;
    constexpr double kRoof = 0.3;
    return cover.share < kLeastShare || cover.share_below > kRoof;
}

}  // namespace campuswalk::scene
