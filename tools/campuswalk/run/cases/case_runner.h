#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"
#include "engine/script/image_tolerance.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/images/sequence_request.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/cases/frame_helpers.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/workers/worker.h"

namespace campuswalk::tools {

class CaseStream;

struct PlaySettings {
    std::filesystem::path output;
    bool images = false;
    bool strict = false;               ///< images that can't be evaluated are failures
    Backend backend;                   ///< of images
    bool log = false;                  ///< send the text log, as Topic::log
    bool events = false;               ///< send the log as JSON lines, as Topic::events
    bool progress = false;             ///< send the walk's simulated time now and then, as Topic::progress
    std::vector<std::string> records;  ///< names of record_kinds()
    UpdateSnapshots update = UpdateSnapshots::none;
    SequenceRequest sequence;
    engine::ImageTolerance tolerance;  ///< of snapshots, unless a walk says otherwise
    std::size_t processes_each = 1;    ///< processes that may draw the frames of one walk
    std::size_t drawing = 1;           ///< workers that draw at the same time, without their helpers
};

/// Plays cases in a worker's process, and makes their images.
class CaseRunner {
public:
    /// `settings` must outlive it.
    explicit CaseRunner(const PlaySettings& settings);

    /// Plays a case that has a walk. The result contains whatever goes wrong. Messages that are sent before
    /// it consist of whole lines.
    engine::WalkResult run(const Case& played, const Send& send);

private:
    /// Null if this process draws all frames of the case.
    std::unique_ptr<FrameHelpers> frame_helpers_for(const Case& played) const;
    void play_into(engine::WalkResult& result, const Case& played, FrameHelpers* helpers,
                   CaseStream& stream) const;

    const PlaySettings& settings_;
    std::shared_ptr<engine::render::RendererStore> renderers_;  ///< null without images
    bool may_fork_ = true;                                      ///< until something is drawn in this process
};

}  // namespace campuswalk::tools
