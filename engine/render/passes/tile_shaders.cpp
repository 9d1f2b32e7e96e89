#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render::shaders {

const std::string_view kDefineMultisampled = "#define MULTISAMPLED\n";

// The farthest depth (the least: depths are reversed) of a tile's pixels and all their samples.
const std::string_view kFarthestFragment = R"(
#if defined(MULTISAMPLED)
uniform sampler2DMS depth_map;
#else
uniform sampler2D depth_map;
#endif
uniform ivec2 tile;  // pixels
uniform ivec2 last;  // pixel
out vec4 fragment;

float farthest_at(ivec2 pixel) {
#if defined(MULTISAMPLED)
    return min(min(texelFetch(depth_map, pixel, 0).r, texelFetch(depth_map, pixel, 1).r),
               min(texelFetch(depth_map, pixel, 2).r, texelFetch(depth_map, pixel, 3).r));
#else
    return texelFetch(depth_map, pixel, 0).r;
#endif
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * tile;
    float farthest = 1.0;
    for (int y = 0; y < tile.y; ++y) {
        for (int x = 0; x < tile.x; ++x) {
            farthest = min(farthest, farthest_at(min(corner + ivec2(x, y), last)));
        }
    }
    fragment = vec4(farthest);
}
)";

}  // namespace campuswalk::engine::render::shaders
