#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "engine/walkspace/explore/explore.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/suggest/campus_text.h"

namespace campuswalk::tools {

/// A suggested walk as it was played.
struct PlayedWalk {
    std::size_t visits = 0;  ///< that it makes
    double seconds = 0.0;    ///< that it takes
    /// Where the feet were in each tick on the way to each visit.
    std::vector<std::vector<Eigen::Vector3d>> paths;
    std::shared_ptr<const scene::Campus> campus;  ///< on which it was played
};

/// Plays as many of the planned visits as pass. The walk is written to `walk_file`, beside the campus file.
/// Throws scene::InputError (no-ground) if not even standing at the spawn does.
PlayedWalk play_visits(const SuggestedCampus& campus, const std::filesystem::path& campus_file,
                       const std::filesystem::path& walk_file, WalkLoader& loader);

/// The doorways that the walk goes through, one at most on the way to each visit, and whether a closed door
/// there would be noticed. `settings`: how what is reached from the spawn was explored,
/// with the grid.
std::vector<SuggestedDoorway> try_doorways(const PlayedWalk& walk, const SuggestedCampus& campus,
                                           const engine::ExploreSettings& settings);

}  // namespace campuswalk::tools
