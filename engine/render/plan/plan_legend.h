#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "engine/render/overlay/canvas.h"
#include "engine/render/plan/storey_plan.h"

namespace campuswalk::engine::render {

/// What is below or beside a plan: what its colours, lines and symbols mean, as far as it has them, and the
/// list of findings. Laid out for a width, pixels, when constructed.
class PlanLegend {
public:
    /// `measure` only measures text. `grid` says how far apart the grid's lines are.
    PlanLegend(const Canvas& measure, const StoreyPlan& plan, const std::string& grid, double width);

    double height() const { return height_; }  ///< pixels
    /// With the upper left corner there.
    void draw(const Canvas& canvas, const Eigen::Vector2d& upper_left) const;

private:
    using Symbol = std::function<void(const Canvas& canvas, const Eigen::Vector2d& middle)>;
    struct Entry {
        Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< upper left corner in the legend
        double symbol_width = 0.0;
        Symbol symbol;  ///< may be empty
        std::string text;
        double text_width = 0.0;  ///< to wrap at; 0: one line
    };
    /// One line, to be placed by flow().
    void add(double symbol_width, Symbol symbol, std::string text);
    void add_cells(const StoreyPlan& plan);
    void add_marks(const StoreyPlan& plan);
    /// From left to right, in as many rows as it takes.
    void flow(const Canvas& measure, double width);
    /// In columns that are about equally long.
    void add_findings(const Canvas& measure, const StoreyPlan& plan, double width);

    std::vector<Entry> entries_;
    double height_ = 0.0;
};

}  // namespace campuswalk::engine::render
