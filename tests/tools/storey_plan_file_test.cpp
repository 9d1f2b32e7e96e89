#include <filesystem>

#include <gtest/gtest.h>

#include "engine/render/image/read_png.h"
#include "engine/render/plan/plan_image.h"
#include "tests/support/temporary_folder.h"
#include "tools/campuswalk/images/images.h"

namespace campuswalk::tools {
namespace {

TEST(StoreyPlanFile, HoldsTheImage) {
    engine::render::StoreyPlan plan;
    plan.title = "storey 1";
    plan.area = {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 5)};
    const support::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "plans/storey-1.png";
    draw_storey_plans({&plan, 1}, file);
    EXPECT_EQ(engine::render::read_png(file).rgba, engine::render::draw_storey_plan(plan).rgba);
}

}  // namespace
}  // namespace campuswalk::tools
