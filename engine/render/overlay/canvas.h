#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/render/image/image.h"

// NOLINTBEGIN(bugprone-reserved-identifier): Cairo's and Pango's names
struct _cairo;
struct _cairo_surface;
struct _PangoContext;
struct _PangoLayout;
// NOLINTEND(bugprone-reserved-identifier)

namespace campuswalk::engine::render {

/// An opaque or translucent colour, sRGB, each 0 to 1.
struct Rgba {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double alpha = 1.0;
};

/// A part of an image, pixels; (x, y) is its upper left corner.
struct PixelRect {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
};

/// The fonts of overlays: fixed files regardless of the machine's font settings, so that text gives the same
/// pixels everywhere. Greyscale anti-aliasing, no hinting.
class Fonts {
public:
    /// The program's own, if it came with fonts, then those of Debian, Ubuntu, Fedora, Arch and openSUSE.
    static std::span<const std::filesystem::path> default_folders();

    /// Throws RenderError if a file is in none of the folders: substitutes would change images.
    explicit Fonts(std::span<const std::filesystem::path> folders = default_folders());

    struct Release {
        void operator()(_PangoContext* context) const;
    };
    _PangoContext* context() const { return context_.get(); }

private:
    std::unique_ptr<_PangoContext, Release> context_;
};

/// Layout of a text.
struct TextStyle {
    double size = 16.0;  ///< pixels
    bool bold = false;
    Rgba color = {1, 1, 1, 1};
    double width = 0.0;                       ///< pixels to wrap at; 0 = no wrapping
    int max_lines = 0;                        ///< then ends in an ellipsis; 0 = no limit
    Rgba outline = {0.05, 0.07, 0.09, 0.75};  ///< of labels
};

/// A copy of an image to draw lines and text on with cairo.
class Canvas {
public:
    Canvas(const Image& image, const Fonts& fonts);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Factor for sizes, which are designed for images 720 pixels high.
    double scale() const;
    _cairo* cairo() const { return cairo_.get(); }

    void set_color(const Rgba& color) const;
    void rounded_rectangle(const PixelRect& rect, double radius) const;
    /// Draws `image`, mapping its pixel p to scale * p + offset, within the current clip.
    void draw_image(const Image& image, double scale, const Eigen::Vector2d& offset) const;

    /// Width and height of the text layout, pixels.
    Eigen::Vector2d text_size(const std::string& text, const TextStyle& style) const;
    /// Draws with the upper left corner at (x, y); returns the height.
    double text(double x, double y, const std::string& text, const TextStyle& style) const;
    /// Draws text centred on (x, y) with an outline, readable on any background.
    void label(double x, double y, const std::string& text, const TextStyle& style) const;

    Image image() const;

private:
    struct Release {
        void operator()(_cairo* cairo) const;
        void operator()(_cairo_surface* surface) const;
        void operator()(_PangoLayout* layout) const;
    };
    std::unique_ptr<_PangoLayout, Release> lay_out(const std::string& text, const TextStyle& style) const;

    int width_ = 0;
    int height_ = 0;
    const Fonts& fonts_;
    std::unique_ptr<_cairo_surface, Release> surface_;
    std::unique_ptr<_cairo, Release> cairo_;
};

}  // namespace campuswalk::engine::render
