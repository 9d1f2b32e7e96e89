#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace campuswalk::engine::render {

/// What a cell of a storey is to a visitor.
enum class PlanCell : std::uint8_t {
    nothing,    ///< no walkable ground
    reached,    ///< by a walk from a spawn
    no_return,  ///< reached, but no way leads back
    unreached,  ///< walkable, but no way leads there
    solid,      ///< a wall or another object
};

/// Square cells in rows from north to south, each row from west to east.
struct PlanRaster {
    Eigen::Vector2d north_west =
        Eigen::Vector2d::Zero();  ///< x and z of the first cell's north-west corner, metres
    double cell_size = 0.25;      ///< metres
    int columns = 0;
    int rows = 0;
    std::vector<PlanCell> cells = {};  ///< columns * rows
    /// Width of the passage at each cell, metres, which then colours what is reached if it is less than the
    /// plan's `widest`; negative if unknown. Empty for plain colours.
    std::vector<float> widths = {};

    /// Makes an empty raster of the grid cells in the box, which are counted from the origin.
    static PlanRaster of_nothing(const Eigen::AlignedBox2i& box, double cell_size) {
        PlanRaster raster{cell_size * box.min().cast<double>(), cell_size, box.sizes().x() + 1,
                          box.sizes().y() + 1};
        raster.cells.assign(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows),
                            PlanCell::nothing);
        return raster;
    }
    /// Returns the index in `cells` of the cell in this column and row.
    std::size_t index(const Eigen::Vector2i& cell) const {
        return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(cell.x());
    }
};

enum class PlanSeverity { error, warning, note };

// Findings and points beyond the plan's area are drawn as arrows at its border.

/// Drawn as a numbered marker; the text is listed in the legend.
struct PlanFinding {
    int number = 0;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< x and z, metres
    std::string text;
    PlanSeverity severity = PlanSeverity::warning;
};

enum class PlanPointKind { spawn, place };

struct PlanPoint {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< x and z, metres
    std::string name;
    PlanPointKind kind = PlanPointKind::place;
};

/// The name of a building, across the middle of what the plan shows of it.
struct PlanBuilding {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< x and z, metres
    std::string name;
};

struct PlanRoute {
    std::string name;  ///< in the legend; may be empty
    /// Its parts on this storey, x and z, metres; an arrow is at the end of each.
    std::vector<std::vector<Eigen::Vector2d>> parts;
};

/// What files of plans name as their software.
inline constexpr const char* kPlanSoftware = "campuswalk plan";

/// What the plan of one storey shows.
struct StoreyPlan {
    std::string title;
    std::string subtitle;                    ///< a smaller line below the title; may be empty
    Eigen::AlignedBox2d area;                ///< x and z that the plan covers, metres; not empty
    std::optional<double> metres_per_pixel;  ///< none: round_resolution() of the area
    PlanRaster raster;
    double narrowest = 0.0;  ///< metres, of passages: the darkest colour
    double widest = 3.0;     ///< metres: passages as wide as that have the plain colour
    std::vector<PlanRoute> routes;
    std::vector<PlanBuilding> buildings;  ///< those whose names matter most first
    std::vector<PlanPoint> points;
    std::vector<PlanFinding> findings;
};

}  // namespace campuswalk::engine::render
