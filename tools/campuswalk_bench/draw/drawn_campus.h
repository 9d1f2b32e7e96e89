#pragma once

#include <span>
#include <vector>

#include "scene/model/model.h"
#include "tools/campuswalk_bench/procedural/generated_campus.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {

/// A campus as a modeller would deliver it: one node per square of `lot` metres and material, textured like
/// the demo campus (except for the lamps), with sharp edges of walls and smooth hills and crowns.
scene::Model drawn_campus(const collision::TriangleMesh& mesh, std::span<const CampusRun> runs, double lot);

/// The eye of an image and the point in its middle, metres.
struct DrawnView {
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
};

/// Up to 24 views at eye height, on the paths up the hills around the courses: towards the course, out over
/// the campus, and across. Little is occluded in them.
std::vector<DrawnView> views_over_hills(const WalkableCampus& campus);

/// 24 views at eye height, looking ahead on two walks between the houses, each along the middle of the campus
/// from one side to the other. `campus` has `lots` lots per side.
std::vector<DrawnView> views_among_houses(const GeneratedCampus& campus, int lots);

}  // namespace campuswalk::tools::bench
