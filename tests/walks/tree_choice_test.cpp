// The choice of tree changes how long a walk takes, and nothing else.

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "config/loader/load_run.h"
#include "engine/observers/json_lines.h"
#include "engine/observers/text_log.h"
#include "engine/simulation/run_walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {
namespace {

namespace fs = std::filesystem;
using collision::TreeKind;

struct Walked {
    std::string log;  ///< as text, then as JSON lines
    WalkSummary summary;
};

/// Builds each campus once with each tree.
class Walker {
public:
    Walked walk(const config::Run& run, TreeKind tree) {
        Walk walk = run.walk;
        walk.sim.tree = tree;
        Walked walked;
        const auto keep = [&](std::string_view line) { (walked.log += line) += '\n'; };
        TextLog text(keep);
        JsonLines json(keep);
        const std::array<Observer*, 2> observers = {&text, &json};
        walked.summary = run_walk(campus_of(*run.campus, tree), walk, observers);
        return walked;
    }

private:
    const scene::Campus& campus_of(const scene::CampusDescription& description, TreeKind tree) {
        std::unique_ptr<scene::Campus>& campus = campuses_[{description.name, tree}];
        if (!campus) {
            std::vector<scene::Diagnostic> warnings;
            campus = std::make_unique<scene::Campus>(
                scene::load_campus(description, collision::make_bullet_broad_phase(), warnings,
                                   scene::import_model, nullptr, 1, tree));
        }
        return *campus;
    }

    std::map<std::pair<std::string, TreeKind>, std::unique_ptr<scene::Campus>> campuses_;
};

std::vector<fs::path> walk_files() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(CAMPUSWALK_SOURCE_DIR) / "config" / "walks")) {
        if (entry.path().string().ends_with(".walk.yaml")) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

TEST(TreeChoice, DoesNotChangeTheLogOfAnyWalk) {
    Walker walker;
    std::size_t walks = 0;
    collision::QueryStatistics on_bvh8;
    collision::QueryStatistics on_hybrid;
    for (const fs::path& file : walk_files()) {
        const config::Run run = config::load_run(file, {});
        const Walked bvh8 = walker.walk(run, TreeKind::bvh8);
        const Walked hybrid = walker.walk(run, TreeKind::hybrid);
        EXPECT_EQ(bvh8.log, hybrid.log) << file;
        EXPECT_EQ(bvh8.summary.hash, hybrid.summary.hash) << file;
        EXPECT_EQ(bvh8.summary.failures.size(), hybrid.summary.failures.size()) << file;
        on_bvh8 += bvh8.summary.statistics;
        on_hybrid += hybrid.summary.statistics;
        ++walks;
    }
    EXPECT_GT(walks, 60U);
    EXPECT_LT(on_bvh8.sphere_tests, on_bvh8.box_tests);
    EXPECT_EQ(on_hybrid.sphere_tests, on_hybrid.volume_tests) << "each node's outer sphere is tested first";
    EXPECT_LT(on_hybrid.box_tests, on_hybrid.sphere_tests) << "and decides some of them";
}

}  // namespace
}  // namespace campuswalk::engine
