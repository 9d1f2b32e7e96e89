#include <cstdio>
#include <vector>

#include "collision/mesh/mesh_contacts.h"
#include "collision/mesh/mesh_query.h"

using namespace campuswalk::collision;

int main() {
    const MeshCollider ground({{{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    const MeshCollider sail({{{0, -1, 0}, {0, -1, 1}, {0, 2, 0}}, {{0, 1, 2}}});
    const Pose X_ground_sail{Mat3::Identity(), Vec3(1, 0, 0.75)};
    std::vector<TrianglePair> pairs;
    all_contacts(ground, sail, X_ground_sail, pairs);
    for (const TrianglePair& pair : pairs) {
        std::printf("ground %u overlaps sail %u\n", pair.a, pair.b);
    }
    if (const auto hit = first_on_ray(ground, {{3, 8, 1}, {3, -2, 1}})) {
        std::printf("a ray down hits ground %u at %g of its length\n", hit->triangle, hit->fraction);
    }
}
