#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision/base/query_statistics.h"
#include "engine/expect/expectation_set.h"
#include "engine/record/tick_record.h"
#include "engine/script/walk.h"
#include "engine/simulation/body.h"
#include "engine/simulation/contact_events.h"
#include "engine/simulation/popup_windows.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Why a walk ended early.
struct Stop {
    SourceMark mark;
    std::string code;  ///< one of kStopCodes, or an expectation's
    std::string message;
    std::optional<FailureScene> scene = {};  ///< none: the end of the walk
    std::optional<Reason> reason = {};       ///< as the message words it
    std::string object = {};                 ///< the one that it is about; may be empty
    std::optional<RouteHint> route = {};     ///< as the message words it
    std::string actual = {};                 ///< as the message words it, with `expected`
    std::string expected = {};
    std::optional<Eigen::Vector3d> at = {};  ///< what to look at
};

/// Ends the message with the reason, or with the object if there is none, and looks at that.
void name_obstacle(Stop& stop);

/// All state that a walk changes, and what has happened in the current tick so far.
struct SimulationState {
    /// Both must outlive it.
    SimulationState(const scene::Campus& campus, const Walk& walk);
    SimulationState(const SimulationState&) = delete;
    SimulationState& operator=(const SimulationState&) = delete;

    const scene::Campus& campus;
    const Walk& walk;
    std::vector<bool> disabled;  ///< by object
    Body body;
    PopupWindows popups;
    ContactEvents contacts;
    ExpectationSet expectations;

    TickEvents events{-1, {}};
    std::vector<const SnapshotStep*> snapshots;
    TickCosts costs;
    collision::QueryStatistics statistics;  ///< of the whole walk, without this tick's `costs`

    const std::string& name_of(collision::ObjectId object) const;
    /// Logs that the avatar was pushed aside.
    void report_push(const Push& push, const std::string& label);
    /// The tick so far.
    TickRecord record() const;
};

}  // namespace campuswalk::engine
