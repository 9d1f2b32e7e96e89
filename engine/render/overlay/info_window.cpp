#include "engine/render/overlay/info_window.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <vector>

#include <cairo.h>

namespace campuswalk::engine::render {
namespace {

constexpr Rgba kPanel = {0.067, 0.094, 0.133, 0.90};
constexpr Rgba kBorder = {1.0, 1.0, 1.0, 0.34};
constexpr Rgba kAccent = {0.62, 0.78, 1.0, 1.0};
constexpr Rgba kBright = {1.0, 1.0, 1.0, 1.0};
constexpr Rgba kBody = {0.90, 0.92, 0.95, 1.0};
constexpr Rgba kShadow = {0.0, 0.0, 0.0, 0.10};

// Pixels in an image 720 high.
constexpr double kWidth = 440.0;
constexpr double kMargin = 40.0;
constexpr double kTop = 64.0;
constexpr double kPadding = 22.0;
constexpr double kGap = 14.0;
constexpr double kTitleSize = 25.0;
constexpr double kBodySize = 15.5;
constexpr double kSmallSize = 14.5;
constexpr double kLabelColumn = 0.31;     // share of the text width
constexpr double kMaxHeightShare = 0.80;  // of the image height, for an expanded window

struct Row {
    std::string label;
    std::string value;
};

std::vector<Row> rows_of(const InfoWindow& window) {
    std::vector<Row> rows;
    if (!window.hours.empty()) {
        rows.push_back({"Hours", readable_hours(window.hours)});
    }
    if (window.floors > 0) {
        rows.push_back({"Floors", std::to_string(window.floors)});
    }
    return rows;
}

// Lays out and draws one window. The same code measures and draws, so frame and content agree.
class WindowRenderer {
public:
    WindowRenderer(const Canvas& canvas, const InfoWindow& window, bool expanded)
        : canvas_(canvas), window_(window), expanded_(expanded), s_(canvas.scale()) {
        width_ = std::min(kWidth * s_, 0.62 * canvas.width());
        inner_ = width_ - 2.0 * kPadding * s_;
        fit_text_lines();
    }

    double width() const { return width_; }
    double height() const { return content(0.0, 0.0, false) + 2.0 * kPadding * s_; }

    void draw(double x, double y) const {
        const double h = height();
        for (int i = 4; i >= 1; --i) {  // drop shadow
            canvas_.set_color(kShadow);
            canvas_.rounded_rectangle({x - i * s_, y - (i - 2) * s_, width_ + 2.0 * i * s_, h + 2.0 * i * s_},
                                      (12.0 + i) * s_);
            cairo_fill(canvas_.cairo());
        }
        canvas_.rounded_rectangle({x, y, width_, h}, 12.0 * s_);
        canvas_.set_color(kPanel);
        cairo_fill_preserve(canvas_.cairo());
        canvas_.set_color(kBorder);
        cairo_set_line_width(canvas_.cairo(), 1.5 * s_);
        cairo_stroke(canvas_.cairo());
        draw_close_icon(x + width_ - 27.0 * s_, y + 30.0 * s_);
        content(x + kPadding * s_, y + kPadding * s_, true);
    }

private:
    TextStyle style(double size, bool bold, const Rgba& color, double width, int max_lines) const {
        return {size * s_, bold, color, width, max_lines};
    }

    double piece(double x, double y, const std::string& text, const TextStyle& text_style,
                 bool drawing) const {
        return drawing ? canvas_.text(x, y, text, text_style) : canvas_.text_size(text, text_style).y();
    }

    // Returns the height of the content; draws it if `drawing` is set.
    double content(double x, double y, bool drawing) const {
        double used =
            piece(x, y, window_.title,
                  style(expanded_ ? kTitleSize : 19.0, true, kBright, inner_ - 26.0 * s_, 2), drawing);
        if (!window_.kind.empty()) {
            used += 4.0 * s_;
            used += piece(x, y + used, window_.kind, style(kSmallSize, false, kAccent, inner_, 1), drawing);
        }
        if (expanded_ && !window_.text.empty() && text_lines_ > 0) {
            used += 13.0 * s_;
            used += piece(x, y + used, window_.text, style(kBodySize, false, kBody, inner_, text_lines_),
                          drawing);
        }
        double gap = 13.0;
        for (const Row& row : rows_of(window_)) {
            used += gap * s_;
            gap = 6.0;
            const double column = kLabelColumn * inner_;
            const double a =
                piece(x, y + used, row.label, style(kSmallSize, true, kAccent, column, 1), drawing);
            const double b = piece(x + column, y + used, row.value,
                                   style(kSmallSize, false, kBright, inner_ - column, 2), drawing);
            used += std::max(a, b);
        }
        return used;
    }

    void fit_text_lines() {
        const double limit = kMaxHeightShare * canvas_.height();
        for (text_lines_ = 14; text_lines_ > 1 && height() > limit; --text_lines_) {
        }
    }

    void draw_close_icon(double x, double y) const {
        const double r = 5.5 * s_;
        cairo_move_to(canvas_.cairo(), x - r, y - r);
        cairo_line_to(canvas_.cairo(), x + r, y + r);
        cairo_move_to(canvas_.cairo(), x + r, y - r);
        cairo_line_to(canvas_.cairo(), x - r, y + r);
        canvas_.set_color({1, 1, 1, 0.75});
        cairo_set_line_width(canvas_.cairo(), 1.7 * s_);
        cairo_stroke(canvas_.cairo());
    }

    const Canvas& canvas_;
    const InfoWindow& window_;
    bool expanded_;
    double s_;
    double width_ = 0.0;
    double inner_ = 0.0;
    int text_lines_ = 0;
};

// A line from the window to a dot on the building, unless the window covers that point.
void draw_leader(const Canvas& canvas, const PixelRect& rect, const Eigen::Vector2d& anchor) {
    const double s = canvas.scale();
    if (anchor.x() > rect.x - 12.0 * s || anchor.x() < 0 || anchor.y() < 0 || anchor.y() > canvas.height()) {
        return;
    }
    const double y = rect.y + std::min(42.0 * s, 0.5 * rect.height);
    for (const bool rim : {true, false}) {
        canvas.set_color(rim ? Rgba{0.05, 0.07, 0.09, 0.55} : Rgba{1, 1, 1, 0.9});
        cairo_set_line_width(canvas.cairo(), (rim ? 4.0 : 1.8) * s);
        cairo_move_to(canvas.cairo(), rect.x, y);
        cairo_line_to(canvas.cairo(), anchor.x(), anchor.y());
        cairo_stroke(canvas.cairo());
        cairo_arc(canvas.cairo(), anchor.x(), anchor.y(), (rim ? 6.2 : 4.6) * s, 0.0, 2.0 * std::numbers::pi);
        cairo_fill(canvas.cairo());
    }
}

void draw_more(const Canvas& canvas, double right, double y, std::size_t count) {
    const double s = canvas.scale();
    const std::string text = "+" + std::to_string(count) + " more";
    const TextStyle style = {kSmallSize * s, true, kBright, 0.0, 1};
    const Eigen::Vector2d size = canvas.text_size(text, style);
    const double width = size.x() + 24.0 * s;
    const double height = size.y() + 10.0 * s;
    canvas.rounded_rectangle({right - width, y, width, height}, 0.5 * height);
    canvas.set_color(kPanel);
    cairo_fill_preserve(canvas.cairo());
    canvas.set_color(kBorder);
    cairo_set_line_width(canvas.cairo(), 1.2 * s);
    cairo_stroke(canvas.cairo());
    canvas.text(right - width + 12.0 * s, y + 5.0 * s, text, style);
}

// Converts "8", "08" or "8:30" to "08:00" or "08:30"; empty for anything else.
std::string clock_time(const std::string& text) {
    int hour = -1;
    int minute = 0;
    int used = 0;
    const auto length = static_cast<int>(text.size());
    const bool with_minutes =
        std::sscanf(text.c_str(), "%2d:%2d%n", &hour, &minute, &used) == 2 && used == length;
    const bool plain =
        !with_minutes && std::sscanf(text.c_str(), "%2d%n", &hour, &used) == 1 && used == length;
    if ((!with_minutes && !plain) || hour < 0 || hour > 24 || minute < 0 || minute > 59) {
        return {};
    }
    std::array<char, 24> out{};
    std::snprintf(out.data(), out.size(), "%02d:%02d", hour, plain ? 0 : minute);
    return out.data();
}

}  // namespace

std::string readable_hours(const std::string& hours) {
    const std::size_t dash = hours.find('-');
    if (dash == std::string::npos) {
        return hours;
    }
    const std::string from = clock_time(hours.substr(0, dash));
    const std::string to = clock_time(hours.substr(dash + 1));
    return from.empty() || to.empty() ? hours : from + " \u2013 " + to;
}

InfoWindow info_window_of(const scene::Building& building, const OpenPopup& popup) {
    return {popup.title.empty() ? building.id : popup.title,
            building.kind,
            building.hours,
            popup.text,
            building.floors,
            std::nullopt};
}

std::vector<PixelRect> draw_info_windows(const Canvas& canvas, std::span<const InfoWindow> windows,
                                         std::size_t max_windows) {
    const double s = canvas.scale();
    std::vector<PixelRect> rects;
    double y = kTop * s;
    double right = canvas.width() - kMargin * s;
    std::size_t drawn = 0;
    for (const InfoWindow& window : windows.first(std::min(windows.size(), max_windows))) {
        const WindowRenderer renderer(canvas, window, drawn == 0);
        const PixelRect rect = {right - renderer.width(), y, renderer.width(), renderer.height()};
        // The first is always drawn, others only if "+n more" still fits below.
        if (drawn > 0 && rect.y + rect.height + 50.0 * s > canvas.height()) {
            break;
        }
        if (window.anchor && drawn == 0) {
            draw_leader(canvas, rect, *window.anchor);
        }
        renderer.draw(rect.x, rect.y);
        rects.push_back(rect);
        y += rect.height + kGap * s;
        ++drawn;
    }
    if (drawn < windows.size()) {
        draw_more(canvas, right, y, windows.size() - drawn);
    }
    return rects;
}

}  // namespace campuswalk::engine::render
