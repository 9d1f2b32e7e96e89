#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/script/avatar.h"
#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/passage/bottlenecks.h"
#include "engine/walkspace/passage/hot_spots.h"
#include "engine/walkspace/passage/narrow_passages.h"
#include "engine/walkspace/passage/traps.h"
#include "engine/walkspace/passage/trigger_overhangs.h"
#include "engine/walkspace/report/subjects.h"
#include "engine/walkspace/space/holes.h"
#include "engine/walkspace/space/separate_grounds.h"
#include "engine/walkspace/space/storeys.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Walkable ground that isn't reached, and why not.
struct IslandReport {
    Island island;
    std::optional<Barrier> barrier;  ///< none: nothing that is reached lies near it
    /// Nobody ever gets in: closed solids surround it. Found of notable islands only.
    bool hollow = false;
};

/// A subject, and how far one walks to it.
struct SubjectReport {
    Subject subject;
    std::optional<double> distance;  ///< reached: from the nearest start, along the chain of strides, metres
};

/// Where a visitor gets to on a campus, where not, and why not.
struct WalkReport {
    WalkSpace space;
    Storeys storeys = {};
    std::vector<SubjectReport> subjects = {};
    std::vector<IslandReport> islands = {};  ///< also small ones: subjects may be on them
    std::vector<Trap> traps = {};
    std::vector<Hole> holes = {};
    std::vector<NarrowPassage> narrow = {};
    std::vector<Bottleneck> bottlenecks = {};
    std::vector<TriggerOverhang> overhangs = {};
    std::vector<HotSpot> hot_spots = {};
    std::vector<SeparateGround> separate = {};  ///< none if all starts' ground is one
};

/// What a report is at.
struct ReportStage {
    int number = 1;    ///< from 1 on: the exploration
    int count = 1;     ///< of all
    std::string text;  ///< a clause: "looking for traps"
};

/// Explores the campus and finds all that a report tells. `settings` as for `explore`; the campus and what
/// they refer to must outlive the call. Passages narrower than `min_width` (metres, at most the body's
/// height) are looked for if that is more than the body's own width. `on_stage` is called
/// as each begins; during the first, `settings.progress` is.
WalkReport report_walks(const scene::Campus& campus, const AvatarProfile& avatar, const WorkerWorlds& worlds,
                        ExploreSettings settings, double min_width = 0.0,
                        const std::function<void(const ReportStage&)>& on_stage = {});

}  // namespace campuswalk::engine
