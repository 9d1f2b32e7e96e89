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

/// A walk that has been played, and its images. References must outlive this.
struct ImageEvaluation {
    std::filesystem::path walk_file;
    const scene::Campus& campus;
    const engine::Walk& walk;
    std::filesystem::path output;      ///< the run's output folder
    std::string folder;                ///< the walk's, below it: where its snapshots are
    UpdateSnapshots update;            ///< of the golden images
    engine::ImageTolerance tolerance;  ///< unless an expectation says otherwise
    const engine::SnapshotStates& moments;
    const engine::render::VisibleBuildingsBySnapshot& visible_buildings;
};

struct EvaluatedImages {
    std::vector<engine::Failure> failures;    ///< in the order of the expectations
    std::vector<engine::Artifact> artifacts;  ///< of those that differ
    std::vector<GoldenUpdate> updates;        ///< golden images to write, if the mode allows it
};

/// Evaluates a walk's ExpectSnapshot and ExpectVisible. For a snapshot that differs from its golden image
/// it writes OUTPUT/FOLDER/NAME-actual.png, -expected.png and, if their sizes are the same, -diff.png. Throws
/// std::runtime_error when something can't be written. A build without rendering never calls it.
EvaluatedImages evaluate_images(const ImageEvaluation& request);

}  // namespace campuswalk::tools
