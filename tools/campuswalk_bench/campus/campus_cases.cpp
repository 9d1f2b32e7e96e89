#include "tools/campuswalk_bench/campus/campus_cases.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include "collision/mesh/mesh_query.h"
#include "tools/campuswalk_bench/campus/answer_check.h"
#include "tools/campuswalk_bench/campus/poll.h"
#include "tools/campuswalk_bench/campus/questions.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"
#include "tools/campuswalk_bench/procedural/generated_campus.h"

namespace campuswalk::tools::bench {

using collision::MeshCollider;
using collision::QueryStatistics;
using collision::Ray;
using collision::Segment;
using collision::TreeKind;
using collision::Vec3;

namespace {

using Fraction = std::optional<double>;
using Triangles = std::vector<std::uint32_t>;

/// One mesh in everybody's tree.
struct Campus {
    explicit Campus(int lots)
        : generated(generated_campus(lots)),
          wide(generated.mesh, TreeKind::bvh8, collision::Interior::unknown),
          paper(generated.mesh, TreeKind::hybrid, collision::Interior::unknown) {}

    GeneratedCampus generated;
    MeshCollider wide;
    MeshCollider paper;
    std::shared_ptr<RayEngine> embree;
    std::shared_ptr<RayEngine> bullet;
    std::shared_ptr<TouchEngine> fcl;
};

template <typename Make, typename Engine>
void load(std::shared_ptr<Engine>& engine, const char* peer, const char* function, const Campus& campus) {
    try {
        engine = make_peer<Make>(peer, function, campus.generated.mesh);
    } catch (const std::exception& error) {
        std::printf("  absent: %s: %s\n", peer, error.what());
    }
}

/// Both trees, asked by `ask(collider, question, answer, counters)`.
template <typename Question, typename Answer, typename Ask>
std::vector<Respondent<Question, Answer>> both_trees(const Campus& campus, const Ask& ask) {
    std::vector<Respondent<Question, Answer>> made;
    for (const auto& [name, collider] :
         {std::pair("wide", &campus.wide), std::pair("paper", &campus.paper)}) {
        made.push_back(
            {name, true,
             [ask, collider = collider](const Question& question, Answer& answer, QueryStatistics& counters) {
                 ask(*collider, question, answer, counters);
             }});
    }
    return made;
}

Poll<Ray, Fraction> first_hits(const Campus& campus, const char* case_name, std::vector<Ray> rays) {
    Poll<Ray, Fraction> poll;
    poll.case_name = case_name;
    poll.query = "first_hit";
    poll.questions = std::move(rays);
    poll.respondents = both_trees<Ray, Fraction>(
        campus, [](const MeshCollider& mesh, const Ray& ray, Fraction& answer, QueryStatistics& counters) {
            const auto hit = first_on_ray(mesh, ray, &counters);
            answer = hit ? Fraction(hit->fraction) : std::nullopt;
        });
    for (const auto& [name, peer] :
         {std::pair("embree_robust", campus.embree), std::pair("bullet_bvh", campus.bullet)}) {
        if (peer) {
            poll.respondents.push_back(
                {name, false, [peer = peer](const Ray& ray, Fraction& answer, QueryStatistics&) {
                     answer = peer->first_on_ray(ray);
                 }});
        }
    }
    poll.is_same = same_hit;
    poll.is_right = [&campus](const Ray& ray, const Fraction& answer) {
        return is_first_hit(campus.generated.mesh, ray, answer);
    };
    return poll;
}

Poll<Ray, char> any_hits(const Campus& campus, std::vector<Ray> rays) {
    Poll<Ray, char> poll;
    poll.case_name = "rays";
    poll.query = "any_hit";
    poll.questions = std::move(rays);
    poll.respondents = both_trees<Ray, char>(
        campus, [](const MeshCollider& mesh, const Ray& ray, char& answer, QueryStatistics& counters) {
            answer = any_on_ray(mesh, ray, &counters) ? 1 : 0;
        });
    return poll;
}

Poll<Segment, Triangles> touches(const Campus& campus, std::vector<Segment> segments) {
    Poll<Segment, Triangles> poll;
    poll.case_name = "avatars";
    poll.query = "touching";
    poll.questions = std::move(segments);
    poll.respondents = both_trees<Segment, Triangles>(
        campus,
        [](const MeshCollider& mesh, const Segment& segment, Triangles& answer, QueryStatistics& counters) {
            triangles_near(mesh, segment, kAvatarRadius, answer, &counters);
        });
    if (campus.fcl) {
        poll.respondents.push_back(
            {"fcl_obbrss", false,
             [fcl = campus.fcl](const Segment& segment, Triangles& answer, QueryStatistics&) {
                 fcl->triangles_near(segment, kAvatarRadius, answer);
             }});
    }
    poll.is_same = [](const Segment&, const Triangles& a, const Triangles& b) { return a == b; };
    poll.is_right = [&campus](const Segment& segment, const Triangles& answer) {
        return is_touching_set(campus.generated.mesh, segment, kAvatarRadius, answer);
    };
    return poll;
}

Poll<Vec3, double> distances(const Campus& campus, const std::vector<Segment>& segments) {
    Poll<Vec3, double> poll;
    poll.case_name = "points";
    poll.query = "closest";
    for (const Segment& segment : segments) {
        poll.questions.push_back(segment.b);
    }
    poll.respondents = both_trees<Vec3, double>(
        campus, [](const MeshCollider& mesh, const Vec3& point, double& answer, QueryStatistics& counters) {
            answer = closest_point(mesh, point, &counters).distance;
        });
    return poll;
}

}  // namespace

CaseResult run_campus_cases(const CampusSize& size, int rounds) {
    Campus campus(size.lots);
    const collision::TriangleMesh& mesh = campus.generated.mesh;
    std::printf("A campus of %zu triangles as one mesh; microseconds a question of %d rounds, one thread.\n",
                mesh.triangles.size(), rounds);
    load<MakeRayEngine>(campus.embree, "embree_robust", kMakeRayEngine, campus);
    load<MakeRayEngine>(campus.bullet, "bullet_bvh", kMakeRayEngine, campus);
    load<MakeTouchEngine>(campus.fcl, "fcl_obbrss", kMakeTouchEngine, campus);
    const std::vector<Ray> rays = eye_rays(campus.generated.feet, 200.0, size.rays, 1);
    const std::vector<Segment> segments = avatars(mesh, size.avatars, 2);
    CaseResult result;
    run(first_hits(campus, "rays", rays), rounds, result);
    run(any_hits(campus, rays), rounds, result);
    run(first_hits(campus, "probes", eye_rays(campus.generated.feet, 5.0, size.probes, 3)), rounds, result);
    run(touches(campus, segments), rounds, result);
    run(distances(campus, segments), rounds, result);
    return result;
}

}  // namespace campuswalk::tools::bench
