#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/osm/geometry/plan_geometry.h"

namespace campuswalk::scene::osm {

/// The height of the ground: level at 0, or two triangles to each square of a grid. Whatever lies on it is
/// split where its slope changes, so that neighbours share edges exactly.
class Terrain {
public:
    /// Level.
    Terrain() = default;
    /// `heights` row by row, from the south-west to the north-east; at least two by two.
    Terrain(const Point& south_west, double cell, std::size_t columns, std::vector<double> heights);

    bool is_level() const { return heights_.empty(); }
    double height(const Point& p) const;
    /// Replaces a triangle by parts of it on which the ground is a plane.
    void split(const std::array<Point, 3>& triangle, std::vector<std::array<Point, 3>>& parts) const;
    /// Its ends and where the ground's slope changes between them.
    std::vector<Point> split(const Point& a, const Point& b) const;
    /// Along the edges.
    double lowest(const Polygons& polygons) const;
    double highest(const Polygons& polygons) const;

private:
    /// Whether the ground is level at 0 around all of these points.
    bool is_level_at(const Point* points, std::size_t count) const;
    double at(std::size_t column, std::size_t row) const { return heights_[row * columns_ + column]; }

    Point south_west_ = Point::Zero();
    double cell_ = 1.0;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<double> heights_;
    /// How many of the grid's points in the rectangle from the south-west aren't at 0; one row and column
    /// more.
    std::vector<std::uint32_t> raised_;
};

}  // namespace campuswalk::scene::osm
