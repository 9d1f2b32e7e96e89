#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/expect/failure.h"
#include "engine/observers/snapshot_states.h"
#include "engine/render/snapshot/visibility_report.h"
#include "engine/report/walk_result.h"
#include "engine/script/image_tolerance.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/logs/golden_log.h"

namespace campuswalk::tools {

/// A walk that has been played, and the images that it took. What is named must outlive it.
struct ImageEvaluation {
    std::filesystem::path walk_file;
    const scene::Campus& campus;
    const engine::Walk& walk;
    std::filesystem::path output;      ///< the run's output folder
    std::string folder;                ///< the walk's, below it: where its snapshots are
    UpdateSnapshots update;            ///< of the kept images
    engine::ImageTolerance tolerance;  ///< where an expectation doesn't say
    const engine::SnapshotStates& moments;
    const engine::render::VisibleBuildingsBySnapshot& visible_buildings;
};

struct EvaluatedImages {
    std::vector<engine::Failure> failures;       ///< in the order of the expectations
    std::vector<engine::Artifact> artifacts;     ///< of those that differ
    std::vector<std::filesystem::path> written;  ///< kept images, as the walk file's path leads to them
};

/// Holds a walk's snapshots against its ExpectSnapshot and ExpectVisible. Of one that differs from what was
/// kept there are then OUTPUT/FOLDER/NAME-actual.png, -expected.png and, if their sizes are the same,
/// -diff.png. Throws std::runtime_error when something can't be written. A build without rendering never
/// calls it.
EvaluatedImages evaluate_images(const ImageEvaluation& trial);

}  // namespace campuswalk::tools
