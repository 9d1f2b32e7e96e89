#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/script/avatar.h"
#include "engine/walkspace/bottlenecks.h"
#include "engine/walkspace/explore.h"
#include "engine/walkspace/holes.h"
#include "engine/walkspace/hot_spots.h"
#include "engine/walkspace/narrow_passages.h"
#include "engine/walkspace/separate_grounds.h"
#include "engine/walkspace/storeys.h"
#include "engine/walkspace/subjects.h"
#include "engine/walkspace/traps.h"
#include "engine/walkspace/trigger_overhangs.h"
#include "engine/walkspace/unreached_ground.h"
#include "engine/walkspace/why_not.h"
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

/// Of a body of this profile, on a campus from all its spawns.
ExploreSettings explore_settings(const scene::Campus& campus, const AvatarProfile& avatar,
                                 int ticks_per_second);

}  // namespace campuswalk::engine
