#include "tools/campuswalk_bench/draw/procedural_textures.h"

#include <algorithm>
#include <array>
#include <string>

namespace campuswalk::tools::bench {

namespace {

constexpr int kSide = 512;  // a power of two: the noise's lattice wraps around by masking

struct Surface {
    const char* name = "";
    std::array<int, 3> color = {0, 0, 0};  ///< sRGB
    int coarse = 0;                        ///< amplitude of noise over 32 pixels, 0 to 255
    int fine = 0;                          ///< over 2 pixels
    int course_height = 0;                 ///< pixels of a row of bricks, stones or planks; 0: none
    int course_width = 0;                  ///< of one of them; every other row is shifted by half of it
};

constexpr std::array<Surface, 5> kSurfaces = {{{"grass", {96, 122, 62}, 26, 40, 0, 0},
                                               {"paving", {158, 152, 142}, 14, 14, 128, 128},
                                               {"bricks", {158, 92, 72}, 20, 16, 16, 64},
                                               {"leaves", {78, 112, 52}, 40, 56, 0, 0},
                                               {"planks", {146, 108, 70}, 18, 12, 32, 512}}};

/// -128 to 127, a hash of the lattice point.
int hash_at(unsigned x, unsigned y, unsigned seed) {
    unsigned h = x * 0x9E3779B1U + y * 0x85EBCA77U + seed * 0xC2B2AE3DU;
    h ^= h >> 15U;
    h *= 0x2C1B3C6DU;
    h ^= h >> 12U;
    h *= 0x297A2D39U;
    h ^= h >> 15U;
    return static_cast<int>(h & 255U) - 128;
}

/// Bilinear interpolation on a lattice of `size` pixels.
int noise_at(int x, int y, int size, unsigned seed) {
    const auto lattice = [&](int cx, int cy) {
        const int mask = kSide / size - 1;
        return hash_at(static_cast<unsigned>(cx & mask), static_cast<unsigned>(cy & mask), seed);
    };
    const int cx = x / size;
    const int cy = y / size;
    const int u = x % size;
    const int v = y % size;
    const int above = lattice(cx, cy) * (size - u) + lattice(cx + 1, cy) * u;
    const int below = lattice(cx, cy + 1) * (size - u) + lattice(cx + 1, cy + 1) * u;
    return (above * (size - v) + below * v) / (size * size);
}

/// The brightness that is added to the colour of a pixel.
int shade(const Surface& surface, int x, int y, unsigned seed) {
    int shade =
        (surface.coarse * noise_at(x, y, 32, seed) + surface.fine * noise_at(x, y, 2, seed + 1)) / 128;
    if (surface.course_height > 0) {
        const int row = y / surface.course_height;
        const int along = (x + row % 2 * surface.course_width / 2) % kSide;
        const bool joint = y % surface.course_height < 2 || along % surface.course_width < 2;
        const int piece = hash_at(static_cast<unsigned>(along / surface.course_width),
                                  static_cast<unsigned>(row), seed + 2);
        shade += joint ? -34 : piece / 10;
    }
    return shade;
}

scene::Texture image_of(const Surface& surface, unsigned seed) {
    scene::Texture texture;
    texture.name = surface.name;
    texture.width = texture.height = kSide;
    texture.rgba.reserve(std::size_t{4} * kSide * kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const int lighter = shade(surface, x, y, seed);
            for (const int channel : surface.color) {
                texture.rgba.push_back(static_cast<std::uint8_t>(std::clamp(channel + lighter, 0, 255)));
            }
            texture.rgba.push_back(255);
        }
    }
    return texture;
}

}  // namespace

std::vector<scene::Texture> surface_images() {
    std::vector<scene::Texture> images;
    images.reserve(std::size(kSurfaces));
    for (const Surface& surface : kSurfaces) {
        images.push_back(image_of(surface, 10U * static_cast<unsigned>(images.size())));
    }
    return images;
}

}  // namespace campuswalk::tools::bench
