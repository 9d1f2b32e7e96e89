// Queries of the whole demo campus by the hybrid tree and by the libraries people would use instead, in one
// process and one thread. Ratios are the point: microseconds belong to the machine. Exit code 1 when the
// hybrid tree gives a wrong answer.

#include <cstdio>
#include <vector>

#include "collision/mesh_query.h"
#include "tests/benchmarks/agreement.h"
#include "tests/benchmarks/bullet_rays.h"
#include "tests/benchmarks/demo_mesh.h"
#include "tests/benchmarks/fcl_capsules.h"
#include "tests/benchmarks/interleaved.h"
#include "tests/benchmarks/layouts.h"
#include "tests/benchmarks/questions.h"

using namespace campuswalk;
using namespace campuswalk::bench;

namespace {

constexpr int kRounds = 11;

using Hits = std::vector<std::optional<double>>;
using Sets = std::vector<std::vector<std::uint32_t>>;

/// Whether the hybrid tree gave no wrong answer.
bool compare_rays(const collision::MeshCollider& campus, const BulletRays& bullet, double length,
                  std::size_t count) {
    const std::vector<collision::Ray> rays = make_rays(campus, length, count, 1);
    Hits ours(count);
    Hits theirs(count);
    Contest contest;
    contest.questions = "first on a ray of " + std::to_string(static_cast<int>(length)) + " m";
    contest.count = count;
    contest.peer_name = "Bullet";
    contest.ours = [&] {
        collision::QueryCounters counters;
        for (std::size_t i = 0; i < count; ++i) {
            const auto hit = first_on_ray(campus, rays[i], counters);
            ours[i] = hit ? std::optional(hit->fraction) : std::nullopt;
        }
    };
    contest.peer = [&] {
        for (std::size_t i = 0; i < count; ++i) {
            theirs[i] = bullet.first_on_ray(rays[i]);
        }
    };
    print_outcome(contest, measure(contest, kRounds));
    Agreement agreement;
    for (std::size_t i = 0; i < count; ++i) {
        compare_hits(campus.mesh(), rays[i], ours[i], theirs[i], agreement);
    }
    print_agreement("Bullet", agreement);
    return agreement.ours_wrong == 0;
}

bool compare_avatars(const collision::MeshCollider& campus, const FclCapsules& fcl, std::size_t count) {
    const std::vector<collision::Segment> avatars = make_avatars(campus, count, 2);
    Sets ours(count);
    Sets theirs(count);
    Contest contest;
    contest.questions = "triangles that an avatar touches";
    contest.count = count;
    contest.peer_name = "FCL";
    contest.ours = [&] {
        collision::QueryCounters counters;
        for (std::size_t i = 0; i < count; ++i) {
            triangles_near(campus, avatars[i], kAvatarRadius, ours[i], counters);
        }
    };
    contest.peer = [&] {
        for (std::size_t i = 0; i < count; ++i) {
            fcl.triangles_near(avatars[i], kAvatarRadius, theirs[i]);
        }
    };
    print_outcome(contest, measure(contest, kRounds));
    Agreement agreement;
    for (std::size_t i = 0; i < count; ++i) {
        compare_sets(campus.mesh(), avatars[i], kAvatarRadius, ours[i], theirs[i], agreement);
    }
    print_agreement("FCL", agreement);
    return agreement.ours_wrong == 0;
}

}  // namespace

int main() {
    const collision::MeshCollider campus = load_demo_mesh();
    const BulletRays bullet(campus.mesh());
    const FclCapsules fcl(campus.mesh());
    std::printf("demo campus, %zu triangles, one mesh; %d rounds, taking turns\n",
                campus.mesh().triangles.size(), kRounds);
    print_heading();
    const bool right[] = {compare_rays(campus, bullet, 5.0, 5000), compare_rays(campus, bullet, 200.0, 2000),
                          compare_avatars(campus, fcl, 2000), compare_layouts(campus, kRounds)};
    return right[0] && right[1] && right[2] && right[3] ? 0 : 1;
}
