#include "scene/osm/relief.h"

#include <algorithm>
#include <cmath>

#include "scene/osm/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kCell = 2.5;  // metres
constexpr double kRiser = 0.16;
constexpr double kTread = 0.32;
constexpr double kMaxRise = 8.0;
constexpr double kGentle = 0.16;  // slope behind the top
constexpr double kMaxCells = 4e6;

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
        const double cone = rise - kGentle * std::max(0.0, std::sqrt(d.x() * d.x() + d.y() * d.y()) - length);
        return along <= -length ? 0.0 : std::max(0.0, std::min(slope, cone));
    }
};

}  // namespace

double length_of(const std::vector<Point>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        length += std::sqrt(d.x() * d.x() + d.y() * d.y());
    }
    return length;
}

std::vector<Point> upward(const Path& path) {
    std::vector<Point> points = path.way->points;
    const std::string_view incline = path.way->tags.get("incline");
    if (incline == "down" || incline.starts_with('-')) {
        std::reverse(points.begin(), points.end());
    }
    return points;
}

double rise_of(const Path& path) {
    const double length = length_of(path.way->points);
    const double steepest = 0.7 * length;
    const auto count = number_of(path.way->tags, "step_count");
    const double rise = count && *count >= 1.0 ? *count * kRiser : std::floor(length / kTread) * kRiser;
    return std::min({rise, steepest, kMaxRise});
}

Terrain relief_of_steps(const std::vector<Path>& paths, const Box& box) {
    std::vector<Flight> flights;
    for (const Path& path : paths) {
        if (!path.steps || path.underground) {
            continue;
        }
        const std::vector<Point> points = upward(path);
        const Point d = points.back() - points.front();
        Flight flight{points.front(), points.back(), Point(0, 1), std::sqrt(d.x() * d.x() + d.y() * d.y()),
                      rise_of(path)};
        if (flight.length > 0.5 && flight.rise > 0.2 && box.contains(flight.top)) {
            flight.up = d / flight.length;
            flights.push_back(flight);
        }
    }
    const Point size = box.size() / kCell;
    if (flights.empty() || size.x() * size.y() > kMaxCells) {
        return {};
    }
    const auto columns = static_cast<std::size_t>(size.x()) + 2;
    const auto rows = static_cast<std::size_t>(size.y()) + 2;
    std::vector<double> heights(columns * rows, 0.0);
    for (const Flight& flight : flights) {
        const auto first = [&](double value) {
            return static_cast<std::size_t>(std::max(0.0, value / kCell));
        };
        const Point low = flight.top - box.min - Point(flight.reach(), flight.reach());
        const Point high = flight.top - box.min + Point(flight.reach(), flight.reach());
        for (std::size_t row = first(low.y()); row < std::min(rows, first(high.y()) + 2); ++row) {
            for (std::size_t column = first(low.x()); column < std::min(columns, first(high.x()) + 2);
                 ++column) {
                const Point p =
                    box.min + kCell * Point(static_cast<double>(column), static_cast<double>(row));
                double& height = heights[row * columns + column];
                height = std::max(height, flight.height(p));
            }
        }
    }
    return Terrain(box.min, kCell, columns, std::move(heights));
}

}  // namespace campuswalk::scene::osm
