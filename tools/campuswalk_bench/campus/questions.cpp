#include "tools/campuswalk_bench/campus/questions.h"

#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::Ray;
using collision::Segment;
using collision::Vec3;

namespace {

std::size_t below(std::size_t count, SplitMix& chance) {
    return static_cast<std::size_t>(chance.between(0.0, static_cast<double>(count)));
}

}  // namespace

std::vector<Ray> eye_rays(std::span<const Vec3> feet, double length, std::size_t count, std::uint32_t seed) {
    SplitMix chance(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Vec3 eye = feet[below(feet.size(), chance)] + Vec3(0.0, kEyeHeight, 0.0);
        rays.push_back({eye, eye + length * chance.direction()});
    }
    return rays;
}

std::vector<Segment> avatars(const collision::TriangleMesh& mesh, std::size_t count, std::uint32_t seed) {
    SplitMix chance(seed);
    std::vector<Segment> made;
    while (made.size() < count) {
        const collision::Triangle near = vertices(mesh, below(mesh.triangles.size(), chance));
        const Vec3 foot = (near.a + near.b + near.c) / 3.0 + 0.5 * chance.direction();
        made.push_back({foot + Vec3(0, kAvatarRadius, 0), foot + Vec3(0, kAvatarHeight - kAvatarRadius, 0)});
    }
    return made;
}

}  // namespace campuswalk::tools::bench
