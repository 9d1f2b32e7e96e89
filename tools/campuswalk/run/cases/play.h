#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"
#include "engine/script/image_tolerance.h"
#include "tools/campuswalk/images/pictures.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/images/sequence_wish.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/workers/frame_helpers.h"
#include "tools/campuswalk/run/workers/worker.h"

namespace campuswalk::tools {

struct PlaySettings {
    std::filesystem::path output;
    bool images = false;
    bool log = false;                  ///< say the text log as it comes
    bool events = false;               ///< say the log as JSON
    bool place = false;                ///< say now and then how far the walk is
    std::vector<std::string> records;  ///< names of record_kinds()
    UpdateSnapshots update = UpdateSnapshots::missing;
    SequenceRequest sequence;
    engine::ImageTolerance tolerance;  ///< of snapshots that are compared, where a walk doesn't say
};

/// What makes the images of all cases that a process plays.
struct ImageMakers {
    std::shared_ptr<engine::render::RendererStore> renderers;  ///< null without images
    FrameHelpers* helpers = nullptr;                           ///< of this case; null when there are none
};

/// Plays a case that has a walk. Whatever goes wrong is in the result; what is said before it are whole
/// lines.
engine::WalkResult play(const Case& played, const PlaySettings& settings, const ImageMakers& makers,
                        const Say& say);

/// Plays it for its frames alone, and draws one part of them: a FrameHelpers::Draw.
void draw_frames(const Case& played, const PlaySettings& settings, engine::render::RendererStore& renderers,
                 std::size_t part, std::size_t parts, const Say& say);

}  // namespace campuswalk::tools
