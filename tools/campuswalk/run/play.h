#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"
#include "engine/script/picture_tolerance.h"
#include "tools/campuswalk/golden_log.h"
#include "tools/campuswalk/pictures.h"
#include "tools/campuswalk/rendering_backend.h"
#include "tools/campuswalk/run/plan.h"
#include "tools/campuswalk/run/worker.h"
#include "tools/campuswalk/sequence_wish.h"

namespace campuswalk::tools {

struct PlaySettings {
    std::filesystem::path output;
    bool pictures = false;
    Backend backend = Backend::automatic;  ///< for `pictures`
    bool log = false;                      ///< say the text log as it comes
    bool events = false;                   ///< say the log as JSON
    std::vector<std::string> records;      ///< names of record_kinds()
    UpdateSnapshots update = UpdateSnapshots::missing;
    SequenceWish sequence;
    engine::PictureTolerance tolerance;  ///< of snapshots that are compared, where a walk doesn't say
};

/// Plays a case that has a walk. Whatever goes wrong is in the result; what is said before it are whole
/// lines. `pictures` is for all cases that a process plays.
engine::WalkResult play(const Case& played, const PlaySettings& settings, FailurePictures& pictures,
                        const Say& say);

}  // namespace campuswalk::tools
