#include "engine/render/compare/pixel_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>

#include "engine/render/image/row_bands.h"

namespace campuswalk::engine::render {
namespace {

constexpr double kLargestSquare = 35215.0;  ///< between yellow and blue, the farthest two colours
constexpr int kEven = 3;                    ///< equal neighbours that make an area an even one

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

/// All four bytes at once: images are opaque.
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

template <typename Visit>
void each_neighbour(const Image& image, int x, int y, const Visit& visit) {
    if (!on_border(image, x, y)) {
        // As below, without a question a neighbour.
        for (int i = -1; i <= 1; ++i) {
            visit(x + i, y - 1);
        }
        visit(x - 1, y);
        visit(x + 1, y);
        for (int i = -1; i <= 1; ++i) {
            visit(x + i, y + 1);
        }
        return;
    }
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.height - 1); ++ny) {
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.width - 1); ++nx) {
            if (nx != x || ny != y) {
                visit(nx, ny);
            }
        }
    }
}

/// What lies beyond the border counts as one equal neighbour.
bool in_even_area(const Image& image, int x, int y) {
    const std::uint8_t* centre = &image.rgba[image.offset(x, y)];
    int equal = on_border(image, x, y) ? 1 : 0;
    each_neighbour(image, x, y, [&](int nx, int ny) {
        equal += same_color(centre, &image.rgba[image.offset(nx, ny)]) ? 1 : 0;
    });
    return equal >= kEven;
}

struct Step {
    int x = 0;
    int y = 0;
};
/// To a pixel's neighbours, in the order of each_neighbour.
constexpr std::array<Step, 8> kAround = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// is_antialiased(), with what gives the brightness at a place.
template <typename LumaAt>
bool antialiased(const Image& image, const Image& other, int x, int y, const LumaAt& luma_at) {
    const double centre = luma_at(x, y);
    const bool border = on_border(image, x, y);
    std::array<double, 8> relative{};  // to the pixel in the middle; 0 for what lies beyond the border
    int beyond = 0;
    for (std::size_t i = 0; i < kAround.size(); ++i) {
        const int nx = x + kAround[i].x;
        const int ny = y + kAround[i].y;
        if (border && (nx < 0 || ny < 0 || nx >= image.width || ny >= image.height)) {
            ++beyond;
        } else {
            relative[i] = luma_at(nx, ny) - centre;
        }
    }
    // Without a branch a neighbour: which of them is darker is as good as chance.
    int equal = (border ? 1 : 0) - beyond;
    double darkest = 0.0;
    double brightest = 0.0;
    for (const double difference : relative) {
        equal += difference == 0.0 ? 1 : 0;
        darkest = difference < darkest ? difference : darkest;
        brightest = difference > brightest ? difference : brightest;
    }
    if (equal >= kEven || darkest == 0.0 || brightest == 0.0) {
        return false;
    }
    const auto even_in_both = [&](double extreme) {
        const Step& way = kAround[static_cast<std::size_t>(
            std::find(relative.begin(), relative.end(), extreme) - relative.begin())];
        return in_even_area(image, x + way.x, y + way.y) && in_even_area(other, x + way.x, y + way.y);
    };
    return even_in_both(darkest) || even_in_both(brightest);
}

/// The brightness of an image's row and of those above and below: in one that differs much, each pixel's is
/// asked for nine times.
class NearLumas {
public:
    explicit NearLumas(const Image& image) : image_(image) {
        for (std::vector<double>& row : rows_) {
            row.resize(static_cast<std::size_t>(image.width));
        }
    }

    /// Before any of them is asked for: the row in the middle.
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

/// Judges the pixels of two images, best row by row.
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
        return antialiased(a_, b_, x, y, std::ref(lumas_a_)) || antialiased(b_, a_, x, y, std::ref(lumas_b_))
                   ? PixelVerdict::antialiased
                   : PixelVerdict::different;
    }

private:
    const Image& a_;
    const Image& b_;
    double largest_square_;
    NearLumas lumas_a_;
    NearLumas lumas_b_;
};

}  // namespace

double color_distance(const std::uint8_t* rgb_a, const std::uint8_t* rgb_b) {
    return std::sqrt(distance_squared(rgb_a, rgb_b) / kLargestSquare);
}

bool is_antialiased(const Image& image, const Image& other, int x, int y) {
    return antialiased(image, other, x, y,
                       [&](int nx, int ny) { return luma(&image.rgba[image.offset(nx, ny)]); });
}

PixelDifference pixel_difference(const Image& a, const Image& b, double threshold, const ImageMask& mask) {
    const double largest_square = kLargestSquare * threshold * threshold;
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(a.width);
    PixelDifference difference;
    difference.verdicts.assign(a.rgba.size() / 4, PixelVerdict::same);
    for_row_bands(a.height, [&](int first, int end) {
        PixelComparer evaluator(a, b, largest_square);
        for (int y = first; y < end; ++y) {
            const std::size_t row = a.offset(0, y);
            if (mask.empty() && std::memcmp(&a.rgba[row], &b.rgba[row], row_bytes) == 0) {
                continue;
            }
            for (int x = 0; x < a.width; ++x) {
                difference.verdicts[a.offset(x, y) / 4] =
                    mask.hides(x, y) ? PixelVerdict::masked : evaluator.verdict(x, y);
            }
        }
    });
    difference.different = static_cast<std::size_t>(
        std::count(difference.verdicts.begin(), difference.verdicts.end(), PixelVerdict::different));
    return difference;
}

}  // namespace campuswalk::engine::render
