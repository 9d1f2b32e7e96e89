// The plans of storeys, of explorations and routes: what is on which of them.

#include "tools/campuswalk/explore/storey_plans.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/report/walk_report.h"
#include "engine/walkspace/route/campus_route.h"
#include "scene/base/diagnostic.h"
#include "tests/engine/small_campus.h"
#include "tools/campuswalk/route/route_plan.h"

namespace campuswalk::tools::explore {
namespace {

using engine::render::PlanCell;
using engine::render::StoreyPlan;

/// Stairs of 0.25 m along the west wall lead up to a gallery at 3 m, under which one walks. On both floors,
/// there is a table that is too high to climb.
scene::Campus two_storeys() {
    scene::Campus campus = engine::walled_yard();
    for (int i = 1; i <= 12; ++i) {
        engine::add_box(campus, "tread-" + std::to_string(i), {-6, -0.1, 5.5 - 0.5 * i},
                        {-4.5, 0.25 * i, 6.0 - 0.5 * i});
    }
    engine::add_box(campus, "gallery", {-6, 2.8, -6}, {2, 3, -0.5});
    engine::add_box(campus, "table-1", {-1, 3, -4}, {1, 3.5, -2.5});
    engine::add_box(campus, "table-0", {3, 0, 3}, {5, 0.5, 4.5});
    campus.description.spawns.push_back({{}, "start", {0, 0, 3}});
    campus.description.places.push_back({{}, "on-table-0", {4, 0.5, 4}});
    campus.description.places.push_back({{}, "on-table-1", {0, 3.5, -3}});
    campus.description.places.push_back({{}, "upstairs", {-2, 3, -5}});
    campus.description.places.push_back({{}, "downstairs", {-2, 0, -5}});
    return campus;
}

struct Plans {
    engine::WalkReport report;
    std::vector<Finding> findings;
    std::vector<StoreyPlan> list;
};

Plans plans_of(const scene::Campus& campus) {
    const engine::WorkerWorlds worlds(campus.world, 1, engine::WorkerWorlds::MakeBroadPhase());
    const engine::ExploreSettings settings = engine::explore_settings(campus, engine::AvatarProfile(), 60);
    engine::WalkReport report = engine::report_walks(campus, engine::AvatarProfile(), worlds, settings);
    std::vector<Finding> findings = find_findings(campus, report);
    std::vector<StoreyPlan> list = storey_plans(campus, report, findings);
    return {std::move(report), std::move(findings), std::move(list)};
}

std::set<std::string> points_on(const StoreyPlan& plan) {
    std::set<std::string> names;
    for (const engine::render::PlanPoint& point : plan.points) {
        names.insert(point.name);
    }
    return names;
}

PlanCell cell_at(const StoreyPlan& plan, double x, double z) {
    const engine::render::PlanRaster& raster = plan.raster;
    const auto column = static_cast<int>(std::floor((x - raster.north_west.x()) / raster.cell_size));
    const auto row = static_cast<int>(std::floor((z - raster.north_west.y()) / raster.cell_size));
    const int cell = row * raster.columns + column;
    return column < 0 || row < 0 || column >= raster.columns || row >= raster.rows
               ? PlanCell::nothing
               : raster.cells[static_cast<std::size_t>(cell)];
}

/// Whether something is drawn within a metre.
bool is_on_ground(const StoreyPlan& plan, const Eigen::Vector2d& at) {
    for (int row = -4; row <= 4; ++row) {
        for (int column = -4; column <= 4; ++column) {
            if (cell_at(plan, at.x() + 0.25 * column, at.y() + 0.25 * row) != PlanCell::nothing) {
                return true;
            }
        }
    }
    return false;
}

TEST(StoreyPlans, ShowWhatIsOnTheirStorey) {
    const Plans plans = plans_of(two_storeys());
    ASSERT_EQ(plans.list.size(), 2U);
    EXPECT_EQ(plans.list[0].title, "small, storey 0 of 0 to 1");
    EXPECT_EQ(plans.list[1].title, "small, storey 1 of 0 to 1");
    EXPECT_EQ(points_on(plans.list[0]), (std::set<std::string>{"start", "on-table-0", "downstairs"}));
    EXPECT_EQ(points_on(plans.list[1]), (std::set<std::string>{"on-table-1", "upstairs"}));
    EXPECT_EQ(cell_at(plans.list[0], 4.0, 4.0), PlanCell::unreached);
    EXPECT_EQ(cell_at(plans.list[1], 0.1, -3.0), PlanCell::unreached);
    EXPECT_EQ(cell_at(plans.list[0], 0.1, -3.0), PlanCell::reached) << "under the gallery";
}

TEST(StoreyPlans, NameTheBuildingsThatStandThere) {
    scene::Campus campus = two_storeys();
    engine::add_building(campus, "library", "The Library");
    engine::add_building(campus, "shed");
    engine::add_building(campus, "cellar", "Cellar");
    engine::add_building(campus, "nothing", "Nothing");
    engine::add_box(campus, "hall", {3, 0, -6}, {5, 8, -3},
                    {collision::Detection::solid, "library", true, ""});
    engine::add_box(campus, "hut", {3, 0, 0}, {4, 1, 1}, {collision::Detection::solid, "shed", true, ""});
    engine::add_box(campus, "vault", {-3, -9, -3}, {3, -5, 3},
                    {collision::Detection::solid, "cellar", true, ""});
    engine::add_box(campus, "around", {-6, 0, -6}, {6, 3, 6},
                    {collision::Detection::trigger, "nothing", true, ""});
    const Plans plans = plans_of(campus);
    ASSERT_EQ(plans.list.size(), 2U);
    const auto names = [](const StoreyPlan& plan) {
        std::vector<std::string> all;
        for (const engine::render::PlanBuilding& building : plan.buildings) {
            all.push_back(building.name);
        }
        return all;
    };
    EXPECT_EQ(names(plans.list[0]), (std::vector<std::string>{"The Library", "shed"})) << "the largest first";
    EXPECT_EQ(names(plans.list[1]), std::vector<std::string>{"The Library"});
    EXPECT_TRUE(plans.list[0].buildings[0].at.isApprox(Eigen::Vector2d(4, -4.5)));
}

TEST(StoreyPlans, NumberFindingsWhereTheirGroundIs) {
    const Plans plans = plans_of(two_storeys());
    const auto numbered = [&](std::size_t storey, const std::string& subject) {
        const auto& marks = plans.list[storey].findings;
        return std::ranges::any_of(marks, [&](const engine::render::PlanFinding& mark) {
            return plans.findings[static_cast<std::size_t>(mark.number) - 1].subject == subject;
        });
    };
    EXPECT_TRUE(numbered(0, "place on-table-0"));
    EXPECT_FALSE(numbered(1, "place on-table-0"));
    EXPECT_TRUE(numbered(1, "place on-table-1"));
    EXPECT_FALSE(numbered(0, "place on-table-1"));
    for (const StoreyPlan& plan : plans.list) {
        EXPECT_FALSE(plan.findings.empty());
        for (const engine::render::PlanFinding& mark : plan.findings) {
            EXPECT_TRUE(is_on_ground(plan, mark.at)) << plan.title << ": " << mark.text;
        }
    }
}

/// Tops of things are no findings of their own, but this one is what a finding is about.
TEST(StoreyPlans, ShowThePlatformThatAPlaceIsOn) {
    scene::Campus campus = engine::walled_yard();
    engine::add_box(campus, "platform", {2, 0, 2}, {5, 1.5, 5});
    engine::add_box(campus, "block", {-5, 0, 2}, {-2, 1.5, 5});
    campus.description.spawns.push_back({{}, "start", {0, 0, 0}});
    campus.description.places.push_back({{}, "stage", {3.5, 1.5, 3.5}});
    const Plans plans = plans_of(campus);
    ASSERT_EQ(plans.list.size(), 1U);
    EXPECT_EQ(cell_at(plans.list[0], 4.1, 4.1), PlanCell::unreached);
    EXPECT_EQ(cell_at(plans.list[0], -4.1, 4.1), PlanCell::nothing);
}

/// Else the yard would be a dot on its own plan.
TEST(StoreyPlans, LeaveWhatIsFarAwayBeyondTheirArea) {
    scene::Campus campus = engine::walled_yard();
    const double far = 1e6;
    engine::add_box(campus, "slab", {far, -0.1, -3}, {far + 6, 0, 3});
    campus.description.spawns.push_back({{}, "start", {0, 0, 0}});
    campus.description.places.push_back({{}, "stray", {far + 3, 0, 0}});
    campus.description.places.push_back({{}, "over-the-wall", {12, 0, 0}});
    const Plans plans = plans_of(campus);
    ASSERT_EQ(plans.list.size(), 1U);
    const StoreyPlan& plan = plans.list[0];
    EXPECT_EQ(points_on(plan), (std::set<std::string>{"start", "stray", "over-the-wall"}));
    EXPECT_TRUE(plan.area.contains(Eigen::Vector2d(12, 0)));
    EXPECT_LT(plan.area.sizes().maxCoeff(), 30.0);
    EXPECT_LT(plan.raster.columns, 100);
}

TEST(StoreyPlans, AreNotMadeOfGroundsTooFarApart) {
    scene::Campus campus = engine::walled_yard();
    engine::add_box(campus, "slab", {9000, -0.1, 9000}, {9006, 0, 9006});
    campus.description.spawns.push_back({{}, "here", {0, 0, 0}});
    campus.description.spawns.push_back({{}, "there", {9003, 0, 9003}});
    try {
        plans_of(campus);
        FAIL() << "81 km² on one plan";
    } catch (const scene::InputError& error) {
        EXPECT_EQ(error.diagnostics().front().code.text(), "plan-too-large");
    }
}

TEST(StoreyPlans, AreNoneIfNothingIsReached) {
    scene::Campus campus = engine::walled_yard();
    campus.description.spawns.push_back({{}, "outside", {100, 0, 0}});
    campus.description.places.push_back({{}, "inside", {0, 0, 0}});
    EXPECT_TRUE(plans_of(campus).list.empty());
}

std::vector<StoreyPlan> plans_of_route(const scene::Campus& campus, const collision::Vec3& to) {
    const engine::RouteSettings settings = engine::route_settings(campus, engine::AvatarProfile(), nullptr);
    engine::RouteRequest request;
    request.from = engine::body_at({0, 0, 3}, campus, settings).value();
    request.to.push_back({"goal", to, true});
    const auto found = engine::route_or_reason(campus, settings, request);
    if (const auto* route = std::get_if<engine::Route>(&found)) {
        return route::route_plans(campus, settings, *route, "start", "goal");
    }
    return route::barrier_plans(campus, settings, request, std::get<engine::Reason>(found), "start", "goal");
}

TEST(StoreyPlans, HaveTheirPartOfARoute) {
    const scene::Campus campus = two_storeys();
    const std::vector<StoreyPlan> below = plans_of_route(campus, {-2, 0, -5});
    ASSERT_EQ(below.size(), 1U);
    EXPECT_EQ(below[0].title, "small, start to goal");
    EXPECT_EQ(points_on(below[0]), (std::set<std::string>{"start", "goal"}));

    const std::vector<StoreyPlan> plans = plans_of_route(campus, {-2, 3, -5});
    ASSERT_EQ(plans.size(), 2U);
    EXPECT_EQ(plans[1].title, "small, start to goal, storey at 3.0 m");
    EXPECT_EQ(points_on(plans[0]), std::set<std::string>{"start"});
    EXPECT_EQ(points_on(plans[1]), std::set<std::string>{"goal"});
    EXPECT_EQ(cell_at(plans[0], 4.1, 4.1), PlanCell::nothing) << "a table";
    EXPECT_EQ(cell_at(plans[1], 0.1, -3.1), PlanCell::nothing) << "a table, under which one walks";
    for (const StoreyPlan& plan : plans) {
        ASSERT_EQ(plan.routes.size(), 1U);
        ASSERT_EQ(plan.routes[0].parts.size(), 1U) << plan.title;
    }
    const Eigen::Vector2d up = plans[0].routes[0].parts[0].back();
    EXPECT_EQ(up, plans[1].routes[0].parts[0].front()) << "where the other goes on";
    EXPECT_LT(up.x(), -4.0) << "on the stairs";
}

TEST(StoreyPlans, HaveAGoalThatNobodyGetsToOnItsStorey) {
    scene::Campus campus = two_storeys();
    for (const double z : {-6.0, -2.2}) {  // a closed room on the gallery
        engine::add_box(campus, "across-" + std::to_string(z), {-4, 3, z}, {1, 6, z + 0.2});
    }
    for (const double x : {-4.0, 0.8}) {
        engine::add_box(campus, "along-" + std::to_string(x), {x, 3, -6}, {x + 0.2, 6, -2});
    }
    const std::vector<StoreyPlan> plans = plans_of_route(campus, {-1.5, 3, -4});
    ASSERT_EQ(plans.size(), 2U);
    EXPECT_EQ(points_on(plans[0]), std::set<std::string>{"start"});
    EXPECT_EQ(points_on(plans[1]), std::set<std::string>{"goal"});
    EXPECT_TRUE(plans[0].findings.empty());
    EXPECT_EQ(plans[1].findings.size(), 1U);
}

TEST(StoreyPlans, OfARouteLeaveAGoalFarAwayBeyondTheirArea) {
    const std::vector<StoreyPlan> plans = plans_of_route(two_storeys(), {1e6, 0, 1e6});
    ASSERT_EQ(plans.size(), 1U);
    EXPECT_EQ(points_on(plans[0]), (std::set<std::string>{"start", "goal"}));
    EXPECT_LT(plans[0].area.sizes().maxCoeff(), 60.0);
}

/// From the gallery one falls into a cell on the ground that nothing leads out of.
TEST(StoreyPlans, NumberATrapWhereOneFallsAndWhereOneIsCaught) {
    scene::Campus campus = two_storeys();
    engine::add_box(campus, "cell/west", {1.8, -0.1, -6}, {2, 2.8, -2});
    engine::add_box(campus, "cell/south", {1.8, -0.1, -2}, {6, 4, -1.8});
    const Plans plans = plans_of(campus);
    ASSERT_EQ(plans.report.traps.size(), 1U);
    for (const StoreyPlan& plan : plans.list) {
        EXPECT_EQ(std::ranges::count_if(plan.findings,
                                        [&](const engine::render::PlanFinding& mark) {
                                            return mark.text.starts_with("trap of ");
                                        }),
                  1)
            << plan.title;
    }
}

}  // namespace
}  // namespace campuswalk::tools::explore
