#include "engine/render/compare/pixel_difference.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

/// All four bytes at once: pictures are opaque.
bool same_color(const std::uint8_t* a, const std::uint8_t* b) {
    std::uint32_t pixel_a = 0;
    std::uint32_t pixel_b = 0;
    std::memcpy(&pixel_a, a, 4);
    std::memcpy(&pixel_b, b, 4);
    return pixel_a == pixel_b;
}

bool on_border(const Picture& picture, int x, int y) {
    return x == 0 || y == 0 || x == picture.width - 1 || y == picture.height - 1;
}

template <typename Visit>
void each_neighbour(const Picture& picture, int x, int y, const Visit& visit) {
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, picture.height - 1); ++ny) {
        for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, picture.width - 1); ++nx) {
            if (nx != x || ny != y) {
                visit(nx, ny);
            }
        }
    }
}

/// What lies beyond the border counts as one equal neighbour.
bool in_even_area(const Picture& picture, int x, int y) {
    const std::uint8_t* centre = &picture.rgba[picture.offset(x, y)];
    int equal = on_border(picture, x, y) ? 1 : 0;
    each_neighbour(picture, x, y, [&](int nx, int ny) {
        equal += same_color(centre, &picture.rgba[picture.offset(nx, ny)]) ? 1 : 0;
    });
    return equal >= kEven;
}

struct Extreme {
    double luma = 0.0;  ///< relative to the pixel in the middle
    int x = 0;
    int y = 0;
};

PixelVerdict verdict(const Picture& a, const Picture& b, double largest_square, int x, int y) {
    const std::size_t offset = a.offset(x, y);
    if (same_color(&a.rgba[offset], &b.rgba[offset])) {
        return PixelVerdict::same;
    }
    if (distance_squared(&a.rgba[offset], &b.rgba[offset]) <= largest_square) {
        return PixelVerdict::close;
    }
    return is_antialiased(a, b, x, y) || is_antialiased(b, a, x, y) ? PixelVerdict::antialiased
                                                                    : PixelVerdict::different;
}

}  // namespace

double color_distance(const std::uint8_t* rgb_a, const std::uint8_t* rgb_b) {
    return std::sqrt(distance_squared(rgb_a, rgb_b) / kLargestSquare);
}

bool is_antialiased(const Picture& picture, const Picture& other, int x, int y) {
    const double centre = luma(&picture.rgba[picture.offset(x, y)]);
    int equal = on_border(picture, x, y) ? 1 : 0;
    Extreme darkest;
    Extreme brightest;
    each_neighbour(picture, x, y, [&](int nx, int ny) {
        const double relative = luma(&picture.rgba[picture.offset(nx, ny)]) - centre;
        equal += relative == 0.0 ? 1 : 0;
        if (relative < darkest.luma) {
            darkest = {relative, nx, ny};
        } else if (relative > brightest.luma) {
            brightest = {relative, nx, ny};
        }
    });
    if (equal >= kEven || darkest.luma == 0.0 || brightest.luma == 0.0) {
        return false;
    }
    const auto even_in_both = [&](const Extreme& at) {
        return in_even_area(picture, at.x, at.y) && in_even_area(other, at.x, at.y);
    };
    return even_in_both(darkest) || even_in_both(brightest);
}

PixelDifference pixel_difference(const Picture& a, const Picture& b, double threshold,
                                 const PictureMask& mask) {
    const double largest_square = kLargestSquare * threshold * threshold;
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(a.width);
    PixelDifference difference;
    difference.verdicts.assign(a.rgba.size() / 4, PixelVerdict::same);
    for (int y = 0; y < a.height; ++y) {
        const std::size_t row = a.offset(0, y);
        if (mask.empty() && std::memcmp(&a.rgba[row], &b.rgba[row], row_bytes) == 0) {
            continue;
        }
        for (int x = 0; x < a.width; ++x) {
            PixelVerdict& of_pixel = difference.verdicts[a.offset(x, y) / 4];
            of_pixel = mask.hides(x, y) ? PixelVerdict::masked : verdict(a, b, largest_square, x, y);
            difference.different += of_pixel == PixelVerdict::different ? 1 : 0;
        }
    }
    return difference;
}

}  // namespace campuswalk::engine::render
