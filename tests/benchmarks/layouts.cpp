#include "tests/benchmarks/layouts.h"

#include <cstdio>
#include <string>
#include <vector>

#include "collision/mesh_query.h"
#include "tests/benchmarks/interleaved.h"
#include "tests/benchmarks/questions.h"

namespace campuswalk::bench {

namespace {

using collision::MeshCollider;
using collision::QueryCounters;

/// `answer(mesh, i, counters)` on both layouts.
template <typename Answer, typename Ask>
bool compare(const char* questions, std::size_t count, int rounds, const MeshCollider& wide,
             const MeshCollider& paper, const Ask& answer) {
    std::vector<Answer> on_wide(count);
    std::vector<Answer> on_paper(count);
    Contest contest;
    contest.questions = questions;
    contest.count = count;
    contest.peer_name = "paper's layout";
    QueryCounters wide_work;
    QueryCounters paper_work;
    contest.ours = [&] {
        wide_work = {};
        for (std::size_t i = 0; i < count; ++i) {
            on_wide[i] = answer(wide, i, wide_work);
        }
    };
    contest.peer = [&] {
        paper_work = {};
        for (std::size_t i = 0; i < count; ++i) {
            on_paper[i] = answer(paper, i, paper_work);
        }
    };
    print_outcome(contest, measure(contest, rounds));
    const auto mean = [count](std::uint64_t sum) {
        return static_cast<double>(sum) / static_cast<double>(count);
    };
    std::printf("    nv, np             wide %.1f, %.1f; paper %.1f, %.1f\n", mean(wide_work.nv),
                mean(wide_work.np), mean(paper_work.nv), mean(paper_work.np));
    std::printf("    answers            %s\n", on_wide == on_paper ? "the same" : "DIFFERENT");
    return on_wide == on_paper;
}

}  // namespace

bool compare_layouts(const MeshCollider& wide, int rounds) {
    const MeshCollider paper(wide.mesh(), collision::Layout::paper);
    const std::vector<collision::Ray> probes = make_rays(wide, 5.0, 5000, 1);
    const std::vector<collision::Ray> views = make_rays(wide, 200.0, 2000, 1);
    const std::vector<collision::Segment> avatars = make_avatars(wide, 2000, 2);
    using Hit = std::optional<collision::MeshHit>;
    using Indices = std::vector<std::uint32_t>;
    bool same = compare<Hit>("first on a ray of 5 m", probes.size(), rounds, wide, paper,
                             [&](const MeshCollider& mesh, std::size_t i, QueryCounters& counters) {
                                 return first_on_ray(mesh, probes[i], counters);
                             });
    same &= compare<Hit>("first on a ray of 200 m", views.size(), rounds, wide, paper,
                         [&](const MeshCollider& mesh, std::size_t i, QueryCounters& counters) {
                             return first_on_ray(mesh, views[i], counters);
                         });
    same &= compare<int>("anything on a ray of 200 m", views.size(), rounds, wide, paper,
                         [&](const MeshCollider& mesh, std::size_t i, QueryCounters& counters) {
                             return any_on_ray(mesh, views[i], counters) ? 1 : 0;
                         });
    same &= compare<Indices>("triangles that an avatar touches", avatars.size(), rounds, wide, paper,
                             [&](const MeshCollider& mesh, std::size_t i, QueryCounters& counters) {
                                 Indices near;
                                 triangles_near(mesh, avatars[i], kAvatarRadius, near, counters);
                                 return near;
                             });
    same &= compare<double>("distance of a point", avatars.size(), rounds, wide, paper,
                            [&](const MeshCollider& mesh, std::size_t i, QueryCounters& counters) {
                                return closest_point(mesh, avatars[i].b, counters).distance;
                            });
    return same;
}

}  // namespace campuswalk::bench
