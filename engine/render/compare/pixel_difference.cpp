#include "engine/render/compare/pixel_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/render/image/row_bands.h"

namespace campuswalk::engine::render {
namespace {

constexpr double kLargestSquare = 35215.0;  ///< between yellow and blue, the most distant colours
constexpr int kMinEqual = 3;                ///< equal neighbours in a uniform area

double luma(const std::uint8_t* rgb) {
    return 0.29889531 * rgb[0] + 0.58662247 * rgb[1] + 0.11448223 * rgb[2];
}

/// 0 to kLargestSquare.
double distance_squared(const std::uint8_t* a, const std::uint8_t* b) {
    const double red = int{a[0]} - int{b[0]};
    const double green = int{a[1]} - int{b[1]};
    const double blue = int{a[2]} - int{b[2]};
    const double y = 0.29889531 * red + 0.58662247 * green + 0.11448223 * blue;
    const double i = 0.59597799 * red - 0.27417610 * green - 0.32180189 * blue;
    const double q = 0.21147017 * red - 0.52261711 * green + 0.31114694 * blue;
    return 0.5053 * y * y + 0.299 * i * i + 0.1957 * q * q;
}

/// Compares all four bytes at once, as images are opaque.
bool same_color(const std::uint8_t* a, const std::uint8_t* b) {
    std::uint32_t pixel_a = 0;
    std::uint32_t pixel_b = 0;
    std::memcpy(&pixel_a, a, 4);
    std::memcpy(&pixel_b, b, 4);
    return pixel_a == pixel_b;
}

bool on_border(const Image& image, int x, int y) {
    return x == 0 || y == 0 || x == image.width - 1 || y == image.height - 1;
}

bool is_inside(const Image& image, int x, int y) {
    return x >= 0 && y >= 0 && x < image.width && y < image.height;
}

/// Offset to a neighbour of a pixel.
struct Step {
    int x = 0;
    int y = 0;
};
constexpr std::array<Step, 8> kNeighbours = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// The outside of the image counts as one equal neighbour.
bool in_uniform_area(const Image& image, int x, int y) {
    const std::uint8_t* centre = &image.rgba[image.offset(x, y)];
    const bool border = on_border(image, x, y);
    int equal = border ? 1 : 0;
    for (const Step& step : kNeighbours) {
        if (!border || is_inside(image, x + step.x, y + step.y)) {
            equal += same_color(centre, &image.rgba[image.offset(x + step.x, y + step.y)]) ? 1 : 0;
        }
    }
    return equal >= kMinEqual;
}

/// Cached luma of a row and its two neighbours: each pixel is read up to nine times.
class LumaRows {
public:
    explicit LumaRows(const Image& image) : image_(image) {
        for (std::vector<double>& row : rows_) {
            row.resize(static_cast<std::size_t>(image.width));
        }
    }

    /// Sets the middle row, before lookups.
    void go_to(int y) {
        if (y == middle_) {
            return;
        }
        const bool next = y == middle_ + 1;
        if (next) {
            std::rotate(rows_.begin(), rows_.begin() + 1, rows_.end());
        }
        for (int i = next ? 1 : -1; i <= 1; ++i) {
            const int place = i + 1;
            if (y + i >= 0 && y + i < image_.height) {
                fill(rows_[static_cast<std::size_t>(place)], y + i);
            }
        }
        middle_ = y;
    }

    double operator()(int x, int y) const {
        const int place = y - middle_ + 1;
        return rows_[static_cast<std::size_t>(place)][static_cast<std::size_t>(x)];
    }

private:
    void fill(std::vector<double>& row, int y) const {
        const std::uint8_t* rgba = &image_.rgba[image_.offset(0, y)];
        for (double& value : row) {
            value = luma(rgba);
            rgba += 4;
        }
    }

    const Image& image_;
    int middle_ = -2;
    std::array<std::vector<double>, 3> rows_;
};

/// Whether a pixel results from anti-aliasing between two uniform areas: it has a darker and a brighter
/// neighbour, at most two equal ones, and its darkest or brightest neighbour is in a uniform area in both
/// images (Vyšniauskas, Anti-aliased pixel and intensity slope detector, 2009).
bool is_antialiased(const Image& image, const Image& other, int x, int y, const LumaRows& luma_at) {
    const double centre = luma_at(x, y);
    const bool border = on_border(image, x, y);
    std::array<double, 8> relative{};  // to the centre pixel; 0 outside of the image
    int outside = 0;
    for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
        const int nx = x + kNeighbours[i].x;
        const int ny = y + kNeighbours[i].y;
        if (border && !is_inside(image, nx, ny)) {
            ++outside;
        } else {
            relative[i] = luma_at(nx, ny) - centre;
        }
    }
    // Branchless, as these comparisons are unpredictable.
    int equal = (border ? 1 : 0) - outside;
    double darkest = 0.0;
    double brightest = 0.0;
    for (const double difference : relative) {
        equal += difference == 0.0 ? 1 : 0;
        darkest = difference < darkest ? difference : darkest;
        brightest = difference > brightest ? difference : brightest;
    }
    if (equal >= kMinEqual || darkest == 0.0 || brightest == 0.0) {
        return false;
    }
    const auto uniform_in_both = [&](double extreme) {
        const Step& step = kNeighbours[static_cast<std::size_t>(
            std::find(relative.begin(), relative.end(), extreme) - relative.begin())];
        return in_uniform_area(image, x + step.x, y + step.y) &&
               in_uniform_area(other, x + step.x, y + step.y);
    };
    return uniform_in_both(darkest) || uniform_in_both(brightest);
}

/// Classifies the pixels of two images, fastest in row order.
class PixelComparer {
public:
    PixelComparer(const Image& a, const Image& b, double largest_square)
        : a_(a), b_(b), largest_square_(largest_square), lumas_a_(a), lumas_b_(b) {}

    PixelVerdict verdict(int x, int y) {
        const std::size_t offset = a_.offset(x, y);
        if (same_color(&a_.rgba[offset], &b_.rgba[offset])) {
            return PixelVerdict::same;
        }
        if (distance_squared(&a_.rgba[offset], &b_.rgba[offset]) <= largest_square_) {
            return PixelVerdict::close;
        }
        lumas_a_.go_to(y);
        lumas_b_.go_to(y);
        return is_antialiased(a_, b_, x, y, lumas_a_) || is_antialiased(b_, a_, x, y, lumas_b_)
                   ? PixelVerdict::antialiased
                   : PixelVerdict::different;
    }

private:
    const Image& a_;
    const Image& b_;
    double largest_square_;
    LumaRows lumas_a_;
    LumaRows lumas_b_;
};

}  // namespace

double color_distance(const std::uint8_t* rgb_a, const std::uint8_t* rgb_b) {
    return std::sqrt(distance_squared(rgb_a, rgb_b) / kLargestSquare);
}

PixelDifference pixel_difference(const Image& a, const Image& b, double threshold, const ImageMask& mask) {
    const double largest_square = kLargestSquare * threshold * threshold;
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(a.width);
    PixelDifference difference;
    difference.verdicts.assign(a.rgba.size() / 4, PixelVerdict::same);
    for_row_bands(a.height, [&](int first, int end) {
        PixelComparer comparer(a, b, largest_square);
        for (int y = first; y < end; ++y) {
            const std::size_t row = a.offset(0, y);
            if (mask.empty() && std::memcmp(&a.rgba[row], &b.rgba[row], row_bytes) == 0) {
                continue;
            }
            for (int x = 0; x < a.width; ++x) {
                difference.verdicts[a.offset(x, y) / 4] =
                    mask.hides(x, y) ? PixelVerdict::masked : comparer.verdict(x, y);
            }
        }
    });
    difference.different = static_cast<std::size_t>(
        std::count(difference.verdicts.begin(), difference.verdicts.end(), PixelVerdict::different));
    return difference;
}

}  // namespace campuswalk::engine::render
