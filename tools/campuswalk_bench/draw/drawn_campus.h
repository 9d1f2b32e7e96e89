#pragma once

#include <span>
#include <vector>

#include "scene/model/model.h"
#include "tools/campuswalk_bench/procedural/generated_campus.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {

/// A campus as a modeller would hand it over: for each square of `lot` metres a node for what is of one
/// material; textured (but for the lamps) as the demo campus is, each edge of a wall sharp, hills and crowns
/// smooth.
scene::Model drawn_campus(const collision::TriangleMesh& mesh, std::span<const CampusRun> runs, double lot);

/// Where an image is taken from and what is in its middle, metres.
struct DrawnView {
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
};

/// Up to 24 views at a person's eyes, on the ways up the hills around the courses: towards the course, out
/// over the campus, and across. Little hides what is behind it.
std::vector<DrawnView> views_over_hills(const WalkableCampus& campus);

/// 24 views at a person's eyes, ahead on two walks between the houses, each along the middle of the campus
/// from one side to the other. `campus` is of `lots` a side.
std::vector<DrawnView> views_among_houses(const GeneratedCampus& campus, int lots);

}  // namespace campuswalk::tools::bench
