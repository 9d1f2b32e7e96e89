#include "engine/render/overlay/canvas.h"

#include <algorithm>
#include <cstring>
#include <numbers>

#include <cairo.h>
#include <pango/pangocairo.h>

namespace campuswalk::engine::render {
namespace {

constexpr double kPi = std::numbers::pi;

// Cairo stores a pixel as a native 32-bit integer with alpha in the highest byte.
cairo_surface_t* to_surface(const Image& image) {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
    cairo_surface_flush(surface);
    unsigned char* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* from = &image.rgba[image.offset(0, y)];
        unsigned char* to = data + static_cast<std::ptrdiff_t>(y) * stride;
        for (int x = 0; x < image.width; ++x, from += 4, to += 4) {
            const std::uint32_t value = 0xFF000000U | (std::uint32_t{from[0]} << 16U) |
                                        (std::uint32_t{from[1]} << 8U) | std::uint32_t{from[2]};
            std::memcpy(to, &value, 4);
        }
    }
    cairo_surface_mark_dirty(surface);
    return surface;
}

}  // namespace

void Canvas::Release::operator()(_cairo* cairo) const {
    cairo_destroy(cairo);
}

void Canvas::Release::operator()(_cairo_surface* surface) const {
    cairo_surface_destroy(surface);
}

void Canvas::Release::operator()(_PangoLayout* layout) const {
    g_object_unref(layout);
}

Canvas::Canvas(const Image& image, const Fonts& fonts)
    : width_(image.width),
      height_(image.height),
      fonts_(fonts),
      surface_(to_surface(image)),
      cairo_(cairo_create(surface_.get())) {}

double Canvas::scale() const {
    return std::clamp(std::min(height_ / 720.0, width_ / 960.0), 0.5, 4.0);
}

void Canvas::set_color(const Rgba& color) const {
    cairo_set_source_rgba(cairo(), color.red, color.green, color.blue, color.alpha);
}

void Canvas::rounded_rectangle(const PixelRect& rect, double radius) const {
    const auto [x, y, width, height] = rect;
    cairo_new_sub_path(cairo());
    cairo_arc(cairo(), x + width - radius, y + radius, radius, -0.5 * kPi, 0.0);
    cairo_arc(cairo(), x + width - radius, y + height - radius, radius, 0.0, 0.5 * kPi);
    cairo_arc(cairo(), x + radius, y + height - radius, radius, 0.5 * kPi, kPi);
    cairo_arc(cairo(), x + radius, y + radius, radius, kPi, 1.5 * kPi);
    cairo_close_path(cairo());
}

void Canvas::draw_image(const Image& image, double scale, const Eigen::Vector2d& offset) const {
    const std::unique_ptr<_cairo_surface, Release> surface(to_surface(image));
    cairo_save(cairo());
    cairo_translate(cairo(), offset.x(), offset.y());
    cairo_scale(cairo(), scale, scale);
    cairo_set_source_surface(cairo(), surface.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo()), CAIRO_FILTER_GOOD);
    cairo_paint(cairo());
    cairo_restore(cairo());
}

std::unique_ptr<_PangoLayout, Canvas::Release> Canvas::lay_out(const std::string& text,
                                                               const TextStyle& style) const {
    std::unique_ptr<_PangoLayout, Release> layout(pango_layout_new(fonts_.context()));
    PangoFontDescription* font = pango_font_description_new();
    pango_font_description_set_family_static(font, "DejaVu Sans,WenQuanYi Micro Hei");
    pango_font_description_set_absolute_size(font, style.size * PANGO_SCALE);
    pango_font_description_set_weight(font, style.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_layout_set_font_description(layout.get(), font);
    pango_font_description_free(font);
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    if (style.width > 0.0) {
        pango_layout_set_width(layout.get(), static_cast<int>(style.width * PANGO_SCALE));
        pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    }
    if (style.max_lines > 0) {
        pango_layout_set_height(layout.get(), -style.max_lines);
        pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
    }
    return layout;
}

Eigen::Vector2d Canvas::text_size(const std::string& text, const TextStyle& style) const {
    const auto layout = lay_out(text, style);
    int width = 0;
    int height = 0;
    pango_layout_get_size(layout.get(), &width, &height);
    return {static_cast<double>(width) / PANGO_SCALE, static_cast<double>(height) / PANGO_SCALE};
}

double Canvas::text(double x, double y, const std::string& text, const TextStyle& style) const {
    const auto layout = lay_out(text, style);
    set_color(style.color);
    cairo_move_to(cairo(), x, y);
    pango_cairo_show_layout(cairo(), layout.get());
    cairo_new_path(cairo());  // the next line doesn't start at this text
    int height = 0;
    pango_layout_get_size(layout.get(), nullptr, &height);
    return static_cast<double>(height) / PANGO_SCALE;
}

void Canvas::label(double x, double y, const std::string& text, const TextStyle& style) const {
    const auto layout = lay_out(text, style);
    int width = 0;
    int height = 0;
    pango_layout_get_size(layout.get(), &width, &height);
    cairo_move_to(cairo(), x - 0.5 * width / PANGO_SCALE, y - 0.5 * height / PANGO_SCALE);
    pango_cairo_layout_path(cairo(), layout.get());
    cairo_set_line_join(cairo(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo(), 0.22 * style.size);
    set_color(style.outline);
    cairo_stroke_preserve(cairo());
    set_color(style.color);
    cairo_fill(cairo());
}

Image Canvas::image() const {
    cairo_surface_flush(surface_.get());
    const unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    Image image = Image::filled(width_, height_);
    for (int y = 0; y < height_; ++y) {
        const unsigned char* from = data + static_cast<std::ptrdiff_t>(y) * stride;
        std::uint8_t* to = &image.rgba[image.offset(0, y)];
        for (int x = 0; x < width_; ++x, from += 4, to += 4) {
            std::uint32_t value = 0;
            std::memcpy(&value, from, 4);
            to[0] = static_cast<std::uint8_t>(value >> 16U);
            to[1] = static_cast<std::uint8_t>(value >> 8U);
            to[2] = static_cast<std::uint8_t>(value);
        }
    }
    return image;
}

}  // namespace campuswalk::engine::render
