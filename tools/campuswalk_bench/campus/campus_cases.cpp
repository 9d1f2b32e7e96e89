#include "tools/campuswalk_bench/campus/campus_cases.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"
#include "collision/mesh/mesh_query.h"
#include "tools/campuswalk_bench/campus/answer_check.h"
#include "tools/campuswalk_bench/campus/compare_answers.h"
#include "tools/campuswalk_bench/campus/query_runs.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/procedural/generated_campus.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::MeshCollider;
using collision::QueryStatistics;
using collision::Ray;
using collision::Segment;
using collision::TreeKind;
using collision::Vec3;

namespace {

/// A case of the CSV: one kind of query on one mesh. The first engine is ours and is the reference.
template <typename Input, typename Answer>
struct QueryCase {
    const char* case_name = "";
    const char* query = "";
    std::vector<Input> inputs;
    std::vector<QueryEngine<Input, Answer>> engines;
    // Peers' answers may differ by rounding: whether two answers are the same up to rounding and, where they
    // aren't, whether each of them is right up to rounding.
    std::function<bool(const Input&, const Answer&, const Answer&)> is_same;
    std::function<bool(const Input&, const Answer&)> is_right;
};

/// How a peer's answers differ from ours.
struct Disagreement {
    std::size_t by_rounding = 0;  ///< both right
    std::size_t ours_wrong = 0;
    std::size_t theirs_wrong = 0;
    Difference difference;  ///< of the wrong ones
};

template <typename Input, typename Answer>
Disagreement compare_with_peer(const QueryCase<Input, Answer>& query_case, const std::vector<Answer>& ours,
                               const std::vector<Answer>& theirs) {
    Disagreement found;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (query_case.is_same(query_case.inputs[i], ours[i], theirs[i])) {
            continue;
        }
        const bool ours_right = query_case.is_right(query_case.inputs[i], ours[i]);
        const bool theirs_right = query_case.is_right(query_case.inputs[i], theirs[i]);
        found.by_rounding += ours_right && theirs_right ? 1U : 0U;
        found.ours_wrong += ours_right ? 0U : 1U;
        found.theirs_wrong += theirs_right ? 0U : 1U;
        if (!theirs_right) {
            found.difference += compare_answers(theirs[i], ours[i]);
        }
    }
    return found;
}

void print_disagreement(const std::string& peer, const std::string& ours, const Disagreement& found) {
    std::printf("%16s    wrong beyond rounding: %zu by %s, %zu by %s; within rounding: %zu\n", "",
                found.theirs_wrong, peer.c_str(), found.ours_wrong, ours.c_str(), found.by_rounding);
}

/// Prints and returns the row of engine `i`; clears `ours_right` if one of our engines is wrong.
template <typename Input, typename Answer>
Row make_row(const QueryCase<Input, Answer>& query_case, const std::vector<QueryRuns<Answer>>& runs,
             std::size_t i, bool& ours_right) {
    const QueryRuns<Answer>& run = runs[i];
    const auto& engine = query_case.engines[i];
    Row row{query_case.case_name, {}, engine.name, query_case.query, run.per_query.least,
            run.per_query.median, {}, {}};
    std::printf("%16s%12.3f%12.3f", row.engine.c_str(), row.least, row.median);
    if (!engine.is_ours) {
        const Disagreement found = compare_with_peer(query_case, runs[0].answers, run.answers);
        std::printf("\n");
        print_disagreement(row.engine, query_case.engines[0].name, found);
        row.difference = found.difference;
        ours_right = ours_right && found.ours_wrong == 0;
        return row;
    }
    row.difference.emplace();
    for (std::size_t q = 0; q < run.answers.size(); ++q) {
        *row.difference += compare_answers(run.answers[q], runs[0].answers[q]);
    }
    ours_right = ours_right && row.difference->none();
    const std::uint64_t count = query_case.inputs.size();
    row.work = {(run.work.volume_tests + count / 2) / count, (run.work.primitive_tests + count / 2) / count,
                (run.work.transform_updates + count / 2) / count};
    std::printf("%10llu%10llu  %s\n", static_cast<unsigned long long>(row.work->volume_tests),
                static_cast<unsigned long long>(row.work->primitive_tests),
                row.difference->none() ? "" : to_string(*row.difference).c_str());
    return row;
}

/// Runs the case on every engine, prints one or two lines per engine and adds their rows.
template <typename Input, typename Answer>
void run_case(const QueryCase<Input, Answer>& query_case, int rounds, CaseResult& result) {
    const auto runs = run_queries(query_case.inputs, query_case.engines, rounds);
    std::printf("%s, %s (%zu)\n%16s%12s%12s%10s%10s\n", query_case.case_name, query_case.query,
                query_case.inputs.size(), "", "least", "median", "nv", "np");
    for (std::size_t i = 0; i < runs.size(); ++i) {
        result.rows.push_back(make_row(query_case, runs, i, result.ours_right));
    }
}

// The inputs of the queries that visitors of a campus cause; for a seed, they are the same on every machine.

constexpr double kEyeHeight = 1.6;     ///< metres
constexpr double kAvatarRadius = 0.3;  ///< metres
constexpr double kAvatarHeight = 1.8;  ///< metres

/// Rays of `length` metres from eye height above some of `feet`, uniformly distributed over all directions.
std::vector<Ray> eye_rays(std::span<const Vec3> feet, double length, std::size_t count, std::uint32_t seed) {
    SplitMix random(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Vec3 eye = feet[random.below(feet.size())] + Vec3(0.0, kEyeHeight, 0.0);
        rays.push_back({eye, eye + length * random.direction()});
    }
    return rays;
}

/// The segments of upright avatars (radius kAvatarRadius, kAvatarHeight tall), most of which touch something.
std::vector<Segment> avatars(const collision::TriangleMesh& mesh, std::size_t count, std::uint32_t seed) {
    SplitMix random(seed);
    std::vector<Segment> made;
    while (made.size() < count) {
        const collision::Triangle near = vertices(mesh, random.below(mesh.triangles.size()));
        const Vec3 foot = (near.a + near.b + near.c) / 3.0 + 0.5 * random.direction();
        made.push_back({foot + Vec3(0, kAvatarRadius, 0), foot + Vec3(0, kAvatarHeight - kAvatarRadius, 0)});
    }
    return made;
}

using Fraction = std::optional<double>;
using Triangles = std::vector<std::uint32_t>;

/// One mesh in the trees of all engines.
struct Campus {
    explicit Campus(int lots)
        : generated(generated_campus(lots)),
          bvh8_collider(generated.mesh, TreeKind::bvh8, collision::Interior::unknown),
          hybrid_collider(generated.mesh, TreeKind::hybrid, collision::Interior::unknown) {}

    GeneratedCampus generated;
    MeshCollider bvh8_collider;
    MeshCollider hybrid_collider;
    std::shared_ptr<RayEngine> embree;
    std::shared_ptr<RayEngine> bullet;
    std::shared_ptr<TouchEngine> fcl;
};

template <typename Make, typename Engine>
void load(std::shared_ptr<Engine>& engine, const char* peer, const char* function, const Campus& campus) {
    unless_absent(peer, [&] { engine = make_peer<Make>(peer, function, campus.generated.mesh); });
}

/// Both trees, queried by `query(collider, input, answer, counters)`.
template <typename Input, typename Answer, typename RunQuery>
std::vector<QueryEngine<Input, Answer>> both_trees(const Campus& campus, const RunQuery& query) {
    std::vector<QueryEngine<Input, Answer>> engines;
    for (const auto& [name, collider] :
         {std::pair("wide", &campus.bvh8_collider), std::pair("paper", &campus.hybrid_collider)}) {
        engines.push_back(
            {name, true,
             [query, collider = collider](const Input& input, Answer& answer, QueryStatistics& counters) {
                 query(*collider, input, answer, counters);
             }});
    }
    return engines;
}

QueryCase<Ray, Fraction> first_hits(const Campus& campus, const char* case_name, std::vector<Ray> rays) {
    auto engines = both_trees<Ray, Fraction>(
        campus, [](const MeshCollider& mesh, const Ray& ray, Fraction& answer, QueryStatistics& counters) {
            const auto hit = first_on_ray(mesh, ray, &counters);
            answer = hit ? Fraction(hit->fraction) : std::nullopt;
        });
    for (const auto& [name, peer] :
         {std::pair("embree_robust", campus.embree), std::pair("bullet_bvh", campus.bullet)}) {
        if (peer) {
            engines.push_back(
                {name, false, [peer = peer](const Ray& ray, Fraction& answer, QueryStatistics&) {
                     answer = peer->first_on_ray(ray);
                 }});
        }
    }
    return {case_name,
            "first_hit",
            std::move(rays),
            std::move(engines),
            same_hit,
            [&campus](const Ray& ray, const Fraction& answer) {
                return is_first_hit(campus.generated.mesh, ray, answer);
            }};
}

QueryCase<Ray, char> any_hits(const Campus& campus, std::vector<Ray> rays) {
    return {"rays",
            "any_hit",
            std::move(rays),
            both_trees<Ray, char>(
                campus, [](const MeshCollider& mesh, const Ray& ray, char& answer,
                           QueryStatistics& counters) { answer = any_on_ray(mesh, ray, &counters) ? 1 : 0; }),
            {},
            {}};
}

QueryCase<Segment, Triangles> touches(const Campus& campus, std::vector<Segment> segments) {
    auto engines = both_trees<Segment, Triangles>(campus, [](const MeshCollider& mesh, const Segment& segment,
                                                             Triangles& answer, QueryStatistics& counters) {
        triangles_near(mesh, segment, kAvatarRadius, answer, &counters);
    });
    if (campus.fcl) {
        engines.push_back({"fcl_obbrss", false,
                           [fcl = campus.fcl](const Segment& segment, Triangles& answer, QueryStatistics&) {
                               fcl->triangles_near(segment, kAvatarRadius, answer);
                           }});
    }
    return {"avatars",
            "touching",
            std::move(segments),
            std::move(engines),
            [](const Segment&, const Triangles& a, const Triangles& b) { return a == b; },
            [&campus](const Segment& segment, const Triangles& answer) {
                return is_touching_set(campus.generated.mesh, segment, kAvatarRadius, answer);
            }};
}

QueryCase<Vec3, double> distances(const Campus& campus, const std::vector<Segment>& segments) {
    std::vector<Vec3> points;
    for (const Segment& segment : segments) {
        points.push_back(segment.b);
    }
    return {"points",
            "closest",
            std::move(points),
            both_trees<Vec3, double>(
                campus,
                [](const MeshCollider& mesh, const Vec3& point, double& answer, QueryStatistics& counters) {
                    answer = closest_point(mesh, point, &counters).distance;
                }),
            {},
            {}};
}

}  // namespace

CaseResult run_campus_cases(const CampusSize& size, int rounds) {
    Campus campus(size.lots);
    const collision::TriangleMesh& mesh = campus.generated.mesh;
    std::printf("A campus of %zu triangles as one mesh; microseconds per query of %d rounds, one thread.\n",
                mesh.triangles.size(), rounds);
    load<MakeRayEngine>(campus.embree, "embree_robust", kMakeRayEngine, campus);
    load<MakeRayEngine>(campus.bullet, "bullet_bvh", kMakeRayEngine, campus);
    load<MakeTouchEngine>(campus.fcl, "fcl_obbrss", kMakeTouchEngine, campus);
    const std::vector<Ray> rays = eye_rays(campus.generated.feet, 200.0, size.rays, 1);
    const std::vector<Segment> segments = avatars(mesh, size.avatars, 2);
    CaseResult result;
    run_case(first_hits(campus, "rays", rays), rounds, result);
    run_case(any_hits(campus, rays), rounds, result);
    run_case(first_hits(campus, "probes", eye_rays(campus.generated.feet, 5.0, size.probes, 3)), rounds,
             result);
    run_case(touches(campus, segments), rounds, result);
    run_case(distances(campus, segments), rounds, result);
    return result;
}

}  // namespace campuswalk::tools::bench
