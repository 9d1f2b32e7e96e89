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

/// The step that ended a walk early.
struct Stop {
    SourceMark mark;
    std::string code;  ///< "blocked", "enclosed", "fell" or "timeout", or that of what was expected there
    std::string message;
    std::optional<FailureScene> scene = {};  ///< none: where the walk ended
};

/// All that a walk changes on its campus, and what the current tick has brought so far.
struct SimulationState {
    /// Both must outlive it.
    SimulationState(const scene::Campus& campus, const Walk& walk);
    SimulationState(const SimulationState&) = delete;
    SimulationState& operator=(const SimulationState&) = delete;

    const scene::Campus& campus;
    const Walk& walk;
    std::vector<bool> disabled;  ///< by object
    Body body;
    PopupWindows windows;
    ContactEvents contacts;
    ExpectationSet expectations;

    TickEvents events{-1, {}};
    std::vector<const SnapshotStep*> snapshots;
    TickCosts costs;
    collision::QueryStatistics statistics;  ///< of the whole walk but for this tick's `costs`

    const std::string& name_of(collision::ObjectId object) const;
    /// Logs where the avatar was pushed aside to.
    void report_push(const Push& push, const std::string& label);
    /// The tick as far as it has come.
    TickRecord record() const;
};

}  // namespace campuswalk::engine
