#include "tools/campuswalk_bench/campus/query_inputs.h"

#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::Ray;
using collision::Segment;
using collision::Vec3;

namespace {

std::size_t below(std::size_t count, SplitMix& random) {
    return static_cast<std::size_t>(random.between(0.0, static_cast<double>(count)));
}

}  // namespace

std::vector<Ray> eye_rays(std::span<const Vec3> feet, double length, std::size_t count, std::uint32_t seed) {
    SplitMix random(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Vec3 eye = feet[below(feet.size(), random)] + Vec3(0.0, kEyeHeight, 0.0);
        rays.push_back({eye, eye + length * random.direction()});
    }
    return rays;
}

std::vector<Segment> avatars(const collision::TriangleMesh& mesh, std::size_t count, std::uint32_t seed) {
    SplitMix random(seed);
    std::vector<Segment> made;
    while (made.size() < count) {
        const collision::Triangle near = vertices(mesh, below(mesh.triangles.size(), random));
        const Vec3 foot = (near.a + near.b + near.c) / 3.0 + 0.5 * random.direction();
        made.push_back({foot + Vec3(0, kAvatarRadius, 0), foot + Vec3(0, kAvatarHeight - kAvatarRadius, 0)});
    }
    return made;
}

}  // namespace campuswalk::tools::bench
