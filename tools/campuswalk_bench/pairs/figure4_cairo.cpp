#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/events/decimals.h"
#include "tools/campuswalk_bench/pairs/figure4.h"

namespace campuswalk::tools::bench {

namespace {

constexpr double kWidth = 960.0;
constexpr double kHeight = 600.0;
constexpr double kLeft = 80.0;
constexpr double kRight = 800.0;  ///< the names of the lines are to the right
constexpr double kTop = 56.0;
constexpr double kBottom = 540.0;

struct Colour {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;
};

constexpr Colour kInk{0.13, 0.13, 0.13};
constexpr Colour kGrid{0.87, 0.87, 0.87};
/// Okabe and Ito's palette for colour-blind readers.
constexpr Colour kLines[] = {{0.84, 0.37, 0.00}, {0.00, 0.45, 0.70}, {0.60, 0.60, 0.60}, {0.80, 0.47, 0.65},
                             {0.90, 0.62, 0.00}, {0.34, 0.71, 0.91}, {0.00, 0.62, 0.45}};

struct Line {
    std::string name;
    std::vector<double> microseconds;
    Colour colour;
    double name_y = 0.0;
};

/// Pairs on a linear x axis, time on a logarithmic y axis: the engines differ by factors.
class Scales {
public:
    Scales(const std::vector<std::size_t>& pairs, const std::vector<Line>& lines) {
        max_pairs_ = std::ceil(static_cast<double>(pairs.back()) / 200.0) * 200.0;
        double least = lines.front().microseconds.front();
        double most = least;
        for (const Line& line : lines) {
            const auto [low, high] = std::minmax_element(line.microseconds.begin(), line.microseconds.end());
            least = std::min(least, *low);
            most = std::max(most, *high);
        }
        low_ = std::floor(std::log10(least));
        high_ = std::ceil(std::log10(most));
    }

    double x(double pairs) const { return kLeft + (kRight - kLeft) * pairs / max_pairs_; }
    double y(double us) const {
        return kBottom - (kBottom - kTop) * (std::log10(us) - low_) / (high_ - low_);
    }
    double max_pairs() const { return max_pairs_; }
    int lowest_decade() const { return static_cast<int>(low_); }
    int highest_decade() const { return static_cast<int>(high_); }

private:
    double max_pairs_ = 1.0;
    double low_ = 0.0;
    double high_ = 1.0;
};

enum class Anchor { left, middle, right };

void set_colour(cairo_t* cr, const Colour& colour) {
    cairo_set_source_rgb(cr, colour.r, colour.g, colour.b);
}

void write(cairo_t* cr, const std::string& text, double x, double y, double size, Anchor anchor) {
    cairo_set_font_size(cr, size);
    cairo_text_extents_t extents;
    cairo_text_extents(cr, text.c_str(), &extents);
    const double back = anchor == Anchor::left ? 0.0 : anchor == Anchor::middle ? 0.5 : 1.0;
    cairo_move_to(cr, x - back * extents.x_advance, y);
    cairo_show_text(cr, text.c_str());
}

void stroke_line(cairo_t* cr, double x0, double y0, double x1, double y1) {
    cairo_move_to(cr, x0, y0);
    cairo_line_to(cr, x1, y1);
    cairo_stroke(cr);
}

std::string duration(int decade) {
    const int digits = std::max(0, -decade);
    return decade >= 3 ? engine::fixed(std::pow(10.0, decade - 3), 0) + " ms"
                       : engine::fixed(std::pow(10.0, decade), digits) + " \u00b5s";
}

void draw_axes(cairo_t* cr, const Scales& scales) {
    cairo_set_line_width(cr, 1.0);
    for (int decade = scales.lowest_decade(); decade <= scales.highest_decade(); ++decade) {
        for (int step = 1; step < 10 && (step == 1 || decade < scales.highest_decade()); ++step) {
            const double y = scales.y(step * std::pow(10.0, decade));
            set_colour(cr, kGrid);
            cairo_set_line_width(cr, step == 1 ? 1.4 : 0.5);
            stroke_line(cr, kLeft, y, kRight, y);
            if (step == 1) {
                set_colour(cr, kInk);
                write(cr, duration(decade), kLeft - 8.0, y + 5.0, 14.0, Anchor::right);
            }
        }
    }
    for (int hundreds = 0; 100.0 * hundreds <= scales.max_pairs(); hundreds += 2) {
        const double pairs = 100.0 * hundreds;
        const double x = scales.x(pairs);
        set_colour(cr, kGrid);
        cairo_set_line_width(cr, 0.5);
        stroke_line(cr, x, kTop, x, kBottom);
        set_colour(cr, kInk);
        write(cr, engine::fixed(pairs, 0), x, kBottom + 20.0, 14.0, Anchor::middle);
    }
    write(cr, "overlapping pairs of triangles", 0.5 * (kLeft + kRight), kBottom + 44.0, 15.0, Anchor::middle);
    write(cr, "All contacts of a teapot and a cylinder: time over the number of contacts", kLeft, kTop - 24.0,
          17.0, Anchor::left);
}

void draw_line(cairo_t* cr, const Scales& scales, const std::vector<std::size_t>& pairs, const Line& line) {
    set_colour(cr, line.colour);
    cairo_set_line_width(cr, 2.0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        cairo_line_to(cr, scales.x(static_cast<double>(pairs[i])), scales.y(line.microseconds[i]));
    }
    cairo_stroke(cr);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        cairo_arc(cr, scales.x(static_cast<double>(pairs[i])), scales.y(line.microseconds[i]), 3.2, 0.0,
                  6.283185307179586);
        cairo_fill(cr);
    }
    const double end = scales.x(static_cast<double>(pairs.back()));
    cairo_set_line_width(cr, 0.8);
    stroke_line(cr, end + 5.0, scales.y(line.microseconds.back()), kRight + 6.0, line.name_y);
    write(cr, line.name, kRight + 10.0, line.name_y + 5.0, 15.0, Anchor::left);
}

/// Puts the names beside the ends of their lines without overlaps.
void place_names(std::vector<Line>& lines, const Scales& scales) {
    constexpr double kApart = 19.0;
    std::sort(lines.begin(), lines.end(),
              [](const Line& a, const Line& b) { return a.microseconds.back() > b.microseconds.back(); });
    double lowest = kTop - kApart;
    for (Line& line : lines) {
        line.name_y = std::max(scales.y(line.microseconds.back()), lowest + kApart);
        lowest = line.name_y;
    }
    double highest = kBottom + kApart;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        line->name_y = std::min(line->name_y, highest - kApart);
        highest = line->name_y;
    }
}

std::vector<Line> lines_of(const Results& results) {
    std::vector<Line> lines;
    for (const EngineName& engine : results.engines) {
        if (engine.is_ours) {
            const Colour colour = kLines[lines.size() % std::size(kLines)];
            lines.push_back({engine.name, results.least_times(engine.name, Query::all), colour, 0.0});
        }
    }
    return lines;
}

void draw(cairo_t* cr, const Results& results) {
    std::vector<Line> lines = lines_of(results);
    const Scales scales(results.pairs, lines);
    place_names(lines, scales);
    cairo_set_source_rgb(cr, 1.0, 1.0, 1.0);
    cairo_paint(cr);
    cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    draw_axes(cr, scales);
    for (const Line& line : lines) {
        draw_line(cr, scales, results.pairs, line);
    }
}

}  // namespace

void plot_figure4(const Results& results, const std::filesystem::path& file) {
    if (file.has_parent_path()) {
        std::filesystem::create_directories(file.parent_path());
    }
    const bool svg = file.extension() == ".svg";
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        svg ? cairo_svg_surface_create(file.c_str(), kWidth, kHeight)
            : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kWidth),
                                         static_cast<int>(kHeight)),
        cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cr(cairo_create(surface.get()), cairo_destroy);
    draw(cr.get(), results);
    cairo_status_t status = cairo_status(cr.get());
    if (status == CAIRO_STATUS_SUCCESS && !svg) {
        status = cairo_surface_write_to_png(surface.get(), file.c_str());
    }
    cairo_surface_finish(surface.get());
    if (status == CAIRO_STATUS_SUCCESS) {
        status = cairo_surface_status(surface.get());
    }
    if (status != CAIRO_STATUS_SUCCESS) {
        throw std::runtime_error("'" + file.string() +
                                 "' couldn't be written: " + cairo_status_to_string(status));
    }
}

}  // namespace campuswalk::tools::bench
