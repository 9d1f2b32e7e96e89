#include "scene/osm/ways/relief.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/geometry/trigonometry.h"
#include "scene/osm/geometry/box_index.h"
#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kCell = 2.5;  // metres
constexpr double kRiser = 0.16;
constexpr double kTread = 0.32;
constexpr double kMaxRise = 8.0;
constexpr double kGentle = 0.16;  // slope behind the top
constexpr double kMaxCells = 4e6;
constexpr double kEmbankment = 1.0 / 1.5;  // slope beside a cutting
constexpr double kRoadSlope = 0.06;        // along what passes there

/// A flight of steps as a function: how high the ground is because of it.
struct Flight {
    Point foot = Point::Zero();
    Point top = Point::Zero();
    Point up = Point(0, 1);  ///< unit
    double length = 0.0;
    double rise = 0.0;

    double reach() const { return rise / kGentle + length; }
    double height(const Point& p) const {
        const Point d = p - top;
        const double along = d.x() * up.x() + d.y() * up.y();
        const double slope = rise * std::clamp(1.0 + along / length, 0.0, 1.0);
        const double cone = rise - kGentle * std::max(0.0, norm(d) - length);
        return along <= -length ? 0.0 : std::max(0.0, std::min(slope, cone));
    }
};

/// A grid of heights over a box, to be raised.
struct HeightGrid {
    Point south_west = Point::Zero();
    std::size_t columns = 0;
    std::vector<double> heights;

    std::size_t rows() const { return heights.size() / columns; }
    Point at(std::size_t column, std::size_t row) const {
        return south_west + kCell * Point(static_cast<double>(column), static_cast<double>(row));
    }
    /// Calls `visit` with the points and heights of the grid within a distance.
    template <typename Visit>
    void around(const Point& center, double reach, const Visit& visit) {
        const auto first = [](double value) {
            return static_cast<std::size_t>(std::max(0.0, value / kCell));
        };
        const Point low = center - south_west - Point(reach, reach);
        const Point high = center - south_west + Point(reach, reach);
        for (std::size_t row = first(low.y()); row < std::min(rows(), first(high.y()) + 2); ++row) {
            for (std::size_t column = first(low.x()); column < std::min(columns, first(high.x()) + 2);
                 ++column) {
                visit(at(column, row), heights[row * columns + column]);
            }
        }
    }
};

/// Over the box; empty if that would be too much.
HeightGrid grid_over(const Box& box) {
    const Point size = box.size() / kCell;
    if (size.x() * size.y() > kMaxCells) {
        return {};
    }
    HeightGrid grid{box.min, static_cast<std::size_t>(size.x()) + 2, {}};
    grid.heights.assign(grid.columns * (static_cast<std::size_t>(size.y()) + 2), 0.0);
    return grid;
}

/// The points of the grid's triangle around a point.
std::array<std::size_t, 3> triangle_around(const HeightGrid& grid, const Point& p) {
    const Point q = (p - grid.south_west) / kCell;
    const auto cell = [](double value, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(count - 2)));
    };
    const std::size_t column = cell(q.x(), grid.columns);
    const std::size_t row = cell(q.y(), grid.rows());
    const bool below = q.x() - static_cast<double>(column) >= q.y() - static_cast<double>(row);
    const std::size_t low = row * grid.columns + column;
    return {low, low + grid.columns + 1, below ? low + 1 : low + grid.columns};
}

/// A grid rounds off where a flight begins and ends: gives it its whole rise there.
void sharpen_ends(const std::vector<Flight>& flights, HeightGrid& grid) {
    BoxIndex near;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        near.add(i, Box{flights[i].top, flights[i].top}.grown(flights[i].reach()));
    }
    const auto exact = [&](const Point& p) {
        double height = 0.0;
        for (const std::size_t i : near.at(p)) {
            height = std::max(height, flights[i].height(p));
        }
        return height;
    };
    for (const Flight& flight : flights) {
        const auto foot = triangle_around(grid, flight.foot);
        const auto top = triangle_around(grid, flight.top);
        if (std::ranges::find_first_of(foot, top) != foot.end()) {
            continue;  // too short
        }
        const double low = exact(flight.foot);
        const double high = exact(flight.top);
        for (std::size_t i = 0; i < foot.size(); ++i) {
            grid.heights[foot[i]] = low;
            grid.heights[top[i]] = high;
        }
    }
}

/// How much higher than it was the ground may be because of what passes there below a bridge.
double allowed(const Cutting& cutting, const Point& p) {
    const Point d = p - cutting.at;
    const double along = std::abs(d.x() * cutting.along.x() + d.y() * cutting.along.y());
    const double across = std::abs(d.x() * cutting.along.y() - d.y() * cutting.along.x());
    return std::max(kEmbankment * std::max(0.0, across - cutting.half_width),
                    kRoadSlope * std::max(0.0, along - cutting.half_length));
}

}  // namespace

double length_of(const std::vector<Point>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        length += norm(d);
    }
    return length;
}

std::vector<Point> upward(const Path& path) {
    std::vector<Point> points = path.way->points;
    const std::string_view incline = path.way->tags.get("incline");
    if (incline.empty() ? path.from_entrance : incline == "down" || incline.starts_with('-')) {
        std::reverse(points.begin(), points.end());
    }
    return points;
}

std::optional<double> slope_of(std::string_view incline) {
    if (incline.starts_with('-')) {
        incline.remove_prefix(1);
    }
    const bool degrees = incline.ends_with("\u00b0");
    if (!degrees && !incline.ends_with('%')) {
        return std::nullopt;
    }
    const auto value = length_of(incline.substr(0, incline.size() - (degrees ? 2 : 1)));
    if (!value || (degrees && *value >= 80.0)) {
        return std::nullopt;
    }
    const collision::SinCos angle = collision::sin_cos(degrees ? *value * kDegree : 0.0);
    return degrees ? angle.sin / angle.cos : 0.01 * *value;
}

double rise_of(const Path& path) {
    const double length = length_of(path.way->points);
    const double steepest = 0.7 * length;
    const auto count = number_of(path.way->tags, "step_count");
    const double slope = slope_of(path.way->tags.get("incline")).value_or(0.0);
    const double rise = slope > 0.0              ? slope * length
                        : count && *count >= 1.0 ? *count * kRiser
                                                 : std::floor(length / kTread) * kRiser;
    return std::min({rise, steepest, kMaxRise});
}

double greatest_rise(const Path& path) {
    constexpr double kSteepest = 0.62;  // 18.6 cm over 30 cm
    constexpr double kHighestRiser = 0.2;
    const double steepest = kSteepest * length_of(path.way->points);
    const auto count = number_of(path.way->tags, "step_count");
    return count && *count >= 1.0 ? std::min(*count * kHighestRiser, std::max(steepest, rise_of(path)))
                                  : steepest;
}

Terrain relief_of_steps(const std::vector<Path>& paths, const Box& box) {
    std::vector<Flight> flights;
    for (const Path& path : paths) {
        if (!path.steps || path.unbuilt || path.hangs()) {
            continue;
        }
        const std::vector<Point> points = upward(path);
        const Point d = points.back() - points.front();
        Flight flight{points.front(), points.back(), Point(0, 1), norm(d), rise_of(path)};
        if (flight.length > 0.5 && flight.rise > 0.2 && box.contains(flight.top)) {
            flight.up = d / flight.length;
            flights.push_back(flight);
        }
    }
    HeightGrid grid = flights.empty() ? HeightGrid() : grid_over(box);
    if (grid.heights.empty()) {
        return {};
    }
    for (const Flight& flight : flights) {
        grid.around(flight.top, flight.reach(),
                    [&](const Point& p, double& height) { height = std::max(height, flight.height(p)); });
    }
    sharpen_ends(flights, grid);
    return Terrain(box.min, kCell, grid.columns, std::move(grid.heights));
}

Terrain with_mounds(const Terrain& base, const Box& box, const std::vector<Mound>& mounds,
                    const std::vector<Cutting>& cuttings) {
    HeightGrid grid = mounds.empty() ? HeightGrid() : grid_over(box);
    if (grid.heights.empty()) {
        return base;
    }
    BoxIndex near_cuttings;
    for (std::size_t i = 0; i < cuttings.size(); ++i) {
        constexpr double kReach = 60.0;  // metres: further away they limit no mound
        near_cuttings.add(i, Box{cuttings[i].at, cuttings[i].at}.grown(kReach));
    }
    for (const Mound& mound : mounds) {
        const double reach = mound.flat + mound.rise / kGentle;
        const std::vector<std::size_t> near = near_cuttings.near(Box{mound.at, mound.at}.grown(reach));
        grid.around(mound.at, reach, [&](const Point& p, double& raised) {
            const Point d = p - mound.at;
            const double distance = norm(d);
            double height = mound.rise - kGentle * std::max(0.0, distance - mound.flat);
            for (const std::size_t i : near) {
                height = std::min(height, allowed(cuttings[i], p));
            }
            raised = std::max(raised, height);
        });
    }
    for (std::size_t row = 0; row < grid.rows(); ++row) {
        for (std::size_t column = 0; column < grid.columns; ++column) {
            grid.heights[row * grid.columns + column] += base.height(grid.at(column, row));
        }
    }
    return Terrain(box.min, kCell, grid.columns, std::move(grid.heights));
}

}  // namespace campuswalk::scene::osm
