#include "scene/osm/geometry/terrain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/osm/geometry/convex_cut.h"

namespace campuswalk::scene::osm {
namespace {

/// The families of parallel lines at which slopes change: x, y or x - y is a whole number of cells.
constexpr std::array<std::array<double, 2>, 3> kCreases = {{{1, 0}, {0, 1}, {1, -1}}};

}  // namespace

Terrain::Terrain(const Point& south_west, double cell, std::size_t columns, std::vector<double> heights)
    : south_west_(south_west),
      cell_(cell),
      columns_(columns),
      rows_(heights.size() / columns),
      heights_(std::move(heights)),
      raised_((columns_ + 1) * (rows_ + 1), 0) {
    const std::size_t stride = columns_ + 1;
    for (std::size_t row = 0; row < rows_; ++row) {
        for (std::size_t column = 0; column < columns_; ++column) {
            raised_[(row + 1) * stride + column + 1] =
                (at(column, row) != 0.0 ? 1U : 0U) + raised_[row * stride + column + 1] +
                raised_[(row + 1) * stride + column] - raised_[row * stride + column];
        }
    }
}

bool Terrain::is_level_at(const Point* points, std::size_t count) const {
    Point low = (points[0] - south_west_) / cell_;
    Point high = low;
    for (std::size_t i = 1; i < count; ++i) {
        const Point q = (points[i] - south_west_) / cell_;
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
    }
    const auto limited = [](double value, std::size_t end) {
        return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(end)));
    };
    const std::size_t left = limited(std::floor(low.x()) - 1.0, columns_ - 1);
    const std::size_t right = limited(std::ceil(high.x()) + 2.0, columns_);
    const std::size_t bottom = limited(std::floor(low.y()) - 1.0, rows_ - 1);
    const std::size_t top = limited(std::ceil(high.y()) + 2.0, rows_);
    const std::size_t stride = columns_ + 1;
    return raised_[top * stride + right] + raised_[bottom * stride + left] ==
           raised_[bottom * stride + right] + raised_[top * stride + left];
}

double Terrain::height(const Point& p) const {
    if (is_level()) {
        return 0.0;
    }
    const Point q = (p - south_west_) / cell_;
    const double x = std::clamp(q.x(), 0.0, static_cast<double>(columns_ - 1));
    const double y = std::clamp(q.y(), 0.0, static_cast<double>(rows_ - 1));
    const std::size_t column = std::min(static_cast<std::size_t>(x), columns_ - 2);
    const std::size_t row = std::min(static_cast<std::size_t>(y), rows_ - 2);
    const double u = x - static_cast<double>(column);
    const double v = y - static_cast<double>(row);
    const double low = at(column, row);
    const double high = at(column + 1, row + 1);
    if (u >= v) {  // below the diagonal
        const double side = at(column + 1, row);
        return low + u * (side - low) + v * (high - side);
    }
    const double side = at(column, row + 1);
    return low + v * (side - low) + u * (high - side);
}

void Terrain::split(const std::array<Point, 3>& triangle, std::vector<std::array<Point, 3>>& parts) const {
    if (is_level() || is_level_at(triangle.data(), triangle.size())) {
        parts.push_back(triangle);
        return;
    }
    std::vector<Convex> pieces = {{triangle.begin(), triangle.end()}};
    for (const auto& crease : kCreases) {
        const double origin = crease[0] * south_west_.x() + crease[1] * south_west_.y();
        std::vector<Convex> done;
        for (Convex& piece : pieces) {
            double low = 1e300;
            double high = -1e300;
            for (const Point& p : piece) {
                const double value = crease[0] * p.x() + crease[1] * p.y() - origin;
                low = std::min(low, value);
                high = std::max(high, value);
            }
            Convex rest = std::move(piece);
            for (double k = std::floor(low / cell_) + 1.0; k * cell_ < high; k += 1.0) {
                auto [below, above] = cut(rest, {{crease[0], crease[1]}, origin + k * cell_});
                if (below.size() >= 3) {
                    done.push_back(std::move(below));
                }
                rest = std::move(above);
            }
            if (rest.size() >= 3) {
                done.push_back(std::move(rest));
            }
        }
        pieces = std::move(done);
    }
    for (const Convex& piece : pieces) {
        for (std::size_t i = 2; i < piece.size(); ++i) {
            parts.push_back({piece[0], piece[i - 1], piece[i]});
        }
    }
}

std::vector<Point> Terrain::split(const Point& a, const Point& b) const {
    const std::array<Point, 2> ends = {a, b};
    if (is_level() || is_level_at(ends.data(), ends.size())) {
        return {a, b};
    }
    std::vector<double> cuts = {0.0, 1.0};
    for (const auto& crease : kCreases) {
        const auto value = [&](const Point& p) {
            return (crease[0] * (p.x() - south_west_.x()) + crease[1] * (p.y() - south_west_.y())) / cell_;
        };
        const double from = value(a);
        const double to = value(b);
        const double first = std::floor(std::min(from, to)) + 1.0;
        for (int k = 0; first + k < std::max(from, to); ++k) {
            cuts.push_back((first + k - from) / (to - from));
        }
    }
    std::ranges::sort(cuts);
    std::vector<Point> points;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (i == 0 || cuts[i] - cuts[i - 1] > 1e-9) {
            points.push_back(cuts[i] >= 1.0 ? b : Point(a + cuts[i] * (b - a)));
        }
    }
    return points;
}

double Terrain::lowest(const Polygons& polygons) const {
    double lowest = is_level() ? 0.0 : 1e300;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; !is_level() && i < polygon.outer.size(); ++i) {
            for (const Point& p : split(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()])) {
                lowest = std::min(lowest, height(p));
            }
        }
    }
    return lowest;
}

double Terrain::highest(const Polygons& polygons) const {
    double highest = is_level() ? 0.0 : -1e300;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; !is_level() && i < polygon.outer.size(); ++i) {
            for (const Point& p : split(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()])) {
                highest = std::max(highest, height(p));
            }
        }
    }
    return highest;
}

}  // namespace campuswalk::scene::osm
