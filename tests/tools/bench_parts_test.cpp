#include <gtest/gtest.h>

#include <algorithm>

#include "collision/mesh/mesh_contacts.h"
#include "collision/mesh/mesh_query.h"
#include "tools/campuswalk_bench/campus/answer_check.h"
#include "tools/campuswalk_bench/campus/compare_answers.h"
#include "tools/campuswalk_bench/campus/query_runs.h"
#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/targets.h"
#include "tools/campuswalk_bench/pairs/pair_scenes.h"
#include "tools/campuswalk_bench/procedural/table1_scene.h"
#include "tools/campuswalk_bench/trees/our_builders.h"

namespace campuswalk::tools::bench {
namespace {

using collision::MeshCollider;
using collision::QueryStatistics;
using collision::Ray;
using collision::TriangleMesh;
using collision::Vec3;

TEST(ShuffledRuns, CountOnlyTheSecondOfTwoRuns) {
    std::vector<int> calls(3, 0);
    // The first of two takes 1000, the second 5, 4, 3, 2, 1 in turn.
    const auto spreads = shuffled_runs(3, 5, [&](std::size_t i) {
        const int call = calls[i]++;
        const int turn = call / 2;
        return call % 2 == 0 ? 1000.0 : 5.0 - turn;
    });
    EXPECT_EQ(calls, (std::vector<int>{10, 10, 10}));
    for (const Spread& spread : spreads) {
        EXPECT_EQ(spread.least, 1.0);
        EXPECT_EQ(spread.median, 3.0);
    }
}

TEST(RunQueries, EveryEngineAnswersEveryQuery) {
    std::vector<QueryEngine<int, double>> engines;
    engines.push_back({"doubles", true, [](int input, double& answer, QueryStatistics& counters) {
                           answer = 2.0 * input;
                           counters.volume_tests += 1;
                       }});
    engines.push_back(
        {"halves", false, [](int input, double& answer, QueryStatistics&) { answer = 0.5 * input; }});
    const auto runs = run_queries<int, double>({1, 2, 5}, engines, 4);
    EXPECT_EQ(runs[0].answers, (std::vector<double>{2.0, 4.0, 10.0}));
    EXPECT_EQ(runs[1].answers, (std::vector<double>{0.5, 1.0, 2.5}));
    EXPECT_EQ(runs[0].work.volume_tests, 3U) << "of one run";
}

TEST(PairScenes, NestedCylindersAreSeparatedByTheGap) {
    const PairScene scene = nested_scene();
    const MeshCollider outer(scene.a);
    const MeshCollider inner(scene.b);
    const collision::Pose& X = scene.placements.at(0).X_a_b;
    EXPECT_FALSE(first_contact(outer, inner, X).has_value());
    double least = 1.0;
    for (const Eigen::Vector3f& vertex : scene.b.positions) {
        least = std::min(least, closest_point(outer, X * vertex.cast<double>()).distance);
    }
    EXPECT_NEAR(least, kNestedGap, 1e-4);
    EXPECT_GE(least, kNestedGap - 1e-6);
    EXPECT_LT(closest_point(outer, Vec3::Zero()).distance, 1.4) << "the outer one is around it";
}

TEST(PairScenes, FinerSceneHasOnePlacementOfTable1) {
    const PairScene table = table1_pair_scene();
    const PairScene finer = finer_scene(2);
    EXPECT_EQ(finer.a.triangles.size(), 2U * 128U * 124U + 2U * 128U);
    EXPECT_GT(finer.b.triangles.size(), 3.9 * 8680.0);
    ASSERT_EQ(finer.placements.size(), 1U);
    EXPECT_EQ(finer.placements[0].X_a_b.translation, table.placements.at(5).X_a_b.translation);
    EXPECT_EQ(table.placements.at(5).pairs, 666U);
    EXPECT_FALSE(finer.placements[0].pairs.has_value());
}

Row row(const char* case_name, const char* engine, const char* query, double least) {
    Row made;
    made.case_name = case_name;
    made.engine = engine;
    made.query = query;
    made.least = least;
    return made;
}

const std::vector<Row> kRows = {
    row("table1", "ours", "all", 2.0),  row("table1", "peer", "all", 10.0),
    row("table1", "ours", "all", 1.0),  row("table1", "peer", "all", 20.0),
    row("table1", "peer", "first", 90), row("nested", "peer", "all", 70.0),
    row("memory", "ours", "bytes", 50), row("table1", "half", "all", 1.0),
};

TEST(Targets, CanBeRatiosOfWholeCases) {
    Target target{"", "table1", "all", "ours", "peer", Measure::mean_ratio, 9.9, {}};
    EXPECT_DOUBLE_EQ(verdict_on(target, kRows).value.value(), 10.0) << "of 5 and 20";
    EXPECT_TRUE(verdict_on(target, kRows).holds);
    target.must = 10.1;
    EXPECT_FALSE(verdict_on(target, kRows).holds);
    target.measure = Measure::worst_ratio;
    EXPECT_DOUBLE_EQ(verdict_on(target, kRows).value.value(), 5.0);
    target.must = 5.0;
    EXPECT_TRUE(verdict_on(target, kRows).holds);
    target.peer = "half";
    EXPECT_FALSE(verdict_on(target, kRows).value.has_value()) << "a placement is missing";
    target.peer = "nobody";
    EXPECT_FALSE(verdict_on(target, kRows).value.has_value());
    target.ours = "nobody";
    target.peer = "peer";
    EXPECT_FALSE(verdict_on(target, kRows).value.has_value());
}

TEST(Targets, CanBeLimits) {
    Target target{"", "memory", "bytes", "ours", "", Measure::figure, 96.0, 48.0};
    EXPECT_EQ(verdict_on(target, kRows).value, 50.0);
    EXPECT_TRUE(verdict_on(target, kRows).holds);
    target.must = 48.0;
    EXPECT_FALSE(verdict_on(target, kRows).holds);
}

TEST(Targets, AimsAreStricterThanLimits) {
    for (const Target& target : targets()) {
        EXPECT_GT(target.must, 0.0) << target.what;
        if (target.aim) {
            EXPECT_EQ(target.measure == Measure::figure, *target.aim < target.must) << target.what;
        }
    }
}

TEST(CompareAnswers, CountsExtraAndMissingResults) {
    using Fraction = std::optional<double>;
    EXPECT_TRUE(compare_answers(Fraction(0.5), Fraction(0.5)).none());
    EXPECT_EQ(compare_answers(Fraction(0.5), Fraction(0.4)), (Difference{1, 1}));
    EXPECT_EQ(compare_answers(Fraction(0.5), std::nullopt), (Difference{1, 0}));
    EXPECT_EQ(compare_answers(std::nullopt, Fraction(0.5)), (Difference{0, 1}));
    EXPECT_EQ(compare_answers('\1', '\0'), (Difference{1, 0}));
    EXPECT_EQ(compare_answers(0.1, 0.2), (Difference{1, 1}));
    EXPECT_TRUE(compare_answers(0.1, 0.1).none());
    EXPECT_EQ(compare_answers(std::vector<std::uint32_t>{1, 4, 5}, {4, 7}), (Difference{2, 1}));
}

/// 2 m wide, at y = 0.
TriangleMesh square() {
    TriangleMesh mesh;
    mesh.positions = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TEST(AnswerCheck, AcceptsOnlyTheFirstHit) {
    TriangleMesh mesh = square();
    const Ray down{{0.3, 6.0, 0.2}, {0.3, -4.0, 0.2}};
    EXPECT_TRUE(is_first_hit(mesh, down, 0.6));
    EXPECT_TRUE(is_first_hit(mesh, down, 0.60005)) << "half a millimetre";
    EXPECT_FALSE(is_first_hit(mesh, down, 0.6005));
    EXPECT_FALSE(is_first_hit(mesh, down, 0.5995));
    EXPECT_FALSE(is_first_hit(mesh, down, std::nullopt));
    for (const Eigen::Vector3f& vertex : square().positions) {
        mesh.positions.push_back(vertex + Eigen::Vector3f(0.0F, 1.0F, 0.0F));
    }
    mesh.triangles.push_back({4, 5, 6});
    mesh.triangles.push_back({4, 6, 7});
    EXPECT_FALSE(is_first_hit(mesh, down, 0.6)) << "another surface is before it";
    EXPECT_TRUE(is_first_hit(mesh, down, 0.5));
}

TEST(AnswerCheck, AcceptsEitherAnswerAtAnEdge) {
    for (const double beside : {-5e-5, 5e-5}) {
        const Ray at_edge{{1.0 + beside, 6.0, 0.2}, {1.0 + beside, -4.0, 0.2}};
        EXPECT_TRUE(is_first_hit(square(), at_edge, 0.6));
        EXPECT_TRUE(is_first_hit(square(), at_edge, std::nullopt));
    }
    const Ray off{{1.01, 6.0, 0.2}, {1.01, -4.0, 0.2}};
    EXPECT_FALSE(is_first_hit(square(), off, 0.6));
    EXPECT_TRUE(is_first_hit(square(), off, std::nullopt));
}

TEST(AnswerCheck, ToleratesMoreForGrazingRays) {
    // The ray drops 1 mm per metre, so a tenth of a millimetre sideways is 10 cm along the ray.
    const Ray grazing{{-2.0, 0.002, 0.0}, {2.0, -0.002, 0.0}};
    EXPECT_TRUE(is_first_hit(square(), grazing, 0.51));
    EXPECT_FALSE(is_first_hit(square(), grazing, 0.6));
}

TEST(AnswerCheck, TreatsAHitAtTheEndAsNone) {
    const Ray ends{{0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};
    EXPECT_TRUE(same_hit(ends, 1.0, std::nullopt));
    EXPECT_TRUE(same_hit(ends, 0.5, 0.5009));
    EXPECT_FALSE(same_hit(ends, 0.5, 0.502));
    EXPECT_FALSE(same_hit(ends, 0.5, std::nullopt));
    EXPECT_TRUE(is_first_hit(square(), ends, std::nullopt));
}

TEST(AnswerCheck, AcceptsOnlyTheTouchedTriangles) {
    const TriangleMesh mesh = square();
    const auto upright = [](double height) {
        return collision::Segment{{0.5, height, -0.5}, {0.5, height + 1.0, -0.5}};
    };
    // The first triangle's nearest edge is the diagonal, sqrt(0.5) away.
    EXPECT_TRUE(is_touching_set(mesh, upright(0.3), 0.4, {1}));
    EXPECT_FALSE(is_touching_set(mesh, upright(0.3), 0.4, {}));
    EXPECT_FALSE(is_touching_set(mesh, upright(0.3), 0.4, {0, 1}));
    EXPECT_TRUE(is_touching_set(mesh, upright(0.4), 0.4, {1})) << "touches within the tolerance";
    EXPECT_TRUE(is_touching_set(mesh, upright(0.4), 0.4, {}));
}

template <typename Elements>
std::size_t spare_bytes(const Elements& elements) {
    return (elements.capacity() - elements.size()) * sizeof(typename Elements::value_type);
}

std::size_t spare_bytes(const collision::Bvh8& tree) {
    return spare_bytes(tree.nodes) + spare_bytes(tree.leaves);
}

std::size_t spare_bytes(const collision::HybridTree& tree) {
    return spare_bytes(tree.nodes) + spare_bytes(tree.order);
}

TEST(OurBuilders, HeapHoldsTheDataAndSpareCapacity) {
    if (heap_in_use() == 0) {
        GTEST_SKIP() << "a sanitizer's allocator isn't counted";
    }
    const TriangleMesh mesh = table1_pair_scene().a;
    for (const auto tree_kind : {collision::TreeKind::bvh8, collision::TreeKind::hybrid}) {
        const auto builder = make_our_builder(mesh, tree_kind);
        const std::size_t before = heap_in_use();
        builder->build();
        const auto held = static_cast<double>(heap_in_use() - before);
        builder->discard();
        EXPECT_NEAR(static_cast<double>(heap_in_use()), static_cast<double>(before), 0.01 * held);
        const MeshCollider collider(mesh, tree_kind);
        const std::size_t spare =
            std::visit([](const auto& tree) { return spare_bytes(tree); }, collider.tree());
        const auto data = static_cast<double>(bytes_of_mesh(mesh) + bytes_of_tree(collider) + spare);
        EXPECT_NEAR(held, data, 0.02 * data) << "an array of the tree isn't counted";
    }
}

}  // namespace
}  // namespace campuswalk::tools::bench
