#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision/world/world.h"
#include "engine/script/avatar.h"
#include "engine/walkspace/explore/explore.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::bench {

/// A campus that is explored, from one spawn.
struct ExploredCampus {
    std::string name;
    std::shared_ptr<const scene::Campus> campus;
    collision::Vec3 spawn = collision::Vec3::Zero();
    engine::AvatarProfile avatar;
    bool run = false;   ///< what its visitors are allowed besides walking
    bool jump = false;  ///< likewise

    const collision::World& world() const { return campus->world; }
    engine::ExploreSettings settings() const;
    engine::WorkerWorlds worlds(std::size_t workers) const;
};

/// All nodes, by tile and number.
std::vector<engine::WalkNodeId> nodes_of(const engine::WalkSpace& space);

/// Where a campus comes from.
struct ExploredCampusSource {
    std::string name;
    std::function<ExploredCampus()> load;  ///< throws, with the reason, where it is missing
};

/// A file of the demo: beside the program's avatars, or else below the current folder.
std::filesystem::path demo_file(const std::filesystem::path& name);

/// The demo campus, and models of others below `data`: recastnavigation's, Gazebo's, a campus game's.
std::vector<ExploredCampusSource> explored_campuses(const std::filesystem::path& data);
/// One lot with a course, made in code.
ExploredCampusSource small_explored_campus();

}  // namespace campuswalk::tools::bench
