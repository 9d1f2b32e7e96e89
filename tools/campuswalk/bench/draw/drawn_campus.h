#pragma once

#include <vector>

#include "scene/model.h"
#include "scene/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {

/// The campus as a modeller would hand it over: lot by lot, a node for what is of one material; textured (but
/// for the lamps) as the demo campus is, each edge of a wall sharp, hills and crowns smooth.
scene::Model drawn_campus(const scene::WalkableCampus& campus);

/// Where a picture is taken from and what is in its middle, metres.
struct DrawnView {
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
};

/// Up to 24 views at a person's eyes, on the ways up the hills around the courses: towards the course, out
/// over the campus, and across.
std::vector<DrawnView> drawn_views(const scene::WalkableCampus& campus);

}  // namespace campuswalk::tools::bench
