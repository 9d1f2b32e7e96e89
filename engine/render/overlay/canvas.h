#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/render/image/image.h"

struct _cairo;
struct _cairo_surface;
struct _PangoContext;
struct _PangoLayout;

namespace campuswalk::engine::render {

/// An opaque or translucent colour, sRGB, each 0 to 1.
struct Rgba {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double alpha = 1.0;
};

/// The fonts that images are lettered with: fixed files, not what the machine's font settings say, so that
/// the same text gives the same pixels everywhere. Grey antialiasing, no hinting.
class Fonts {
public:
    /// Where Debian and Ubuntu, Fedora, Arch and openSUSE put them.
    static std::span<const std::filesystem::path> usual_folders();

    /// Throws RenderError when a file isn't in any of the folders: boxes instead of letters would be another
    /// image than elsewhere.
    explicit Fonts(std::span<const std::filesystem::path> folders = usual_folders());

    struct Release {
        void operator()(_PangoContext* context) const;
    };
    _PangoContext* context() const { return context_.get(); }

private:
    std::unique_ptr<_PangoContext, Release> context_;
};

/// How a piece of text is set.
struct TextStyle {
    double size = 16.0;  ///< pixels
    bool bold = false;
    Rgba color = {1, 1, 1, 1};
    double width = 0.0;  ///< pixels to wrap at; 0 = one line
    int max_lines = 0;   ///< more are cut with an ellipsis; 0 = no limit
};

/// An image to draw lines and letters on with cairo: take the pixels over, draw, give them back.
class Canvas {
public:
    Canvas(const Image& image, const Fonts& fonts);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Sizes are made for images 720 pixels high; others multiply them by this.
    double scale() const;
    _cairo* cairo() const { return cairo_.get(); }

    void set_color(const Rgba& color) const;
    void rounded_rectangle(double x, double y, double width, double height, double radius) const;
    /// Paints `image` so that its pixel p lands on scale * p + offset; only inside the current clip.
    void draw_image(const Image& image, double scale, const Eigen::Vector2d& offset) const;

    /// Width and height in pixels of the text as set.
    Eigen::Vector2d text_size(const std::string& text, const TextStyle& style) const;
    /// Draws with the upper left corner at (x, y); returns the height.
    double text(double x, double y, const std::string& text, const TextStyle& style) const;
    /// Draws one line centred on (x, y) with a dark rim, readable on any ground.
    void label(double x, double y, const std::string& text, const TextStyle& style) const;

    Image image() const;

private:
    struct Release {
        void operator()(_cairo* cairo) const;
        void operator()(_cairo_surface* surface) const;
        void operator()(_PangoLayout* layout) const;
    };
    std::unique_ptr<_PangoLayout, Release> set_text(const std::string& text, const TextStyle& style) const;

    int width_ = 0;
    int height_ = 0;
    const Fonts& fonts_;
    std::unique_ptr<_cairo_surface, Release> surface_;
    std::unique_ptr<_cairo, Release> cairo_;
};

}  // namespace campuswalk::engine::render
