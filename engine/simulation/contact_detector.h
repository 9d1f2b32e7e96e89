#pragma once

#include <cstdint>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/mover/mover.h"
#include "collision/world/world.h"
#include "engine/events/contact_tracker.h"
#include "engine/events/gaze_tracker.h"
#include "engine/record/tick_record.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

enum class DetectionMode { solid, trigger, ray };

/// A transition with the mode that detected it.
struct DetectedTransition {
    DetectionMode mode = DetectionMode::solid;
    Transition transition;
    double distance = 0.0;  ///< ray: from the eye to the object, metres
};

/// The paper's three detection modes for one avatar: the solids that it touches, the volumes that it is in,
/// and the object that it looks at ("light projection").
class ContactDetector {
public:
    /// `ignored_layers` and `disabled` as in collision::QueryFilter; `gaze_hold` as in GazeTracker.
    ContactDetector(const scene::Campus& campus, const AvatarProfile& avatar, std::uint32_t ignored_layers,
                    Tick stay_ticks, Tick gaze_hold = 0, const std::vector<bool>* disabled = nullptr);

    /// After a tick that moved the avatar along `trace.path`. Replaces `out`, in log order: by time within
    /// the tick, exits before enters before stays, then by object.
    void detect(Tick tick, const AvatarState& avatar, const collision::MoveTrace& trace,
                std::vector<DetectedTransition>& out, collision::QueryStatistics* statistics = nullptr);

    /// After `detect` in the same tick, if objects have been enabled or disabled since: only enters and
    /// exits. Contacts with disabled objects end at once, even gazes. Replaces `out`, in the same order.
    void detect_again(Tick tick, const AvatarState& avatar, const collision::MoveTrace& trace,
                      std::vector<DetectedTransition>& out, collision::QueryStatistics* statistics = nullptr);

    /// Ends all contacts. Replaces `out`, in the same order.
    void leave_all(Tick tick, std::vector<DetectedTransition>& out);

private:
    void find_solid_contacts(const collision::MoveTrace& trace);
    void find_trigger_overlaps(double height, const collision::MoveTrace& trace,
                               collision::QueryStatistics* statistics);
    ObjectOverlap trigger_overlap(collision::ObjectId id, double height,
                                  const std::vector<collision::Vec3>& path,
                                  collision::QueryStatistics* statistics) const;
    void find_gaze_hits(Tick tick, const AvatarState& avatar, collision::QueryStatistics* statistics);
    void collect(Tick tick, DetectionMode mode, ContactTracker& tracker,
                 std::vector<DetectedTransition>& out);

    const scene::Campus& campus_;
    AvatarProfile avatar_;
    std::uint32_t ignored_layers_;
    const std::vector<bool>* disabled_;
    ContactTracker solids_;
    ContactTracker triggers_;
    ContactTracker gaze_;
    GazeTracker gaze_tracker_;
    std::vector<ObjectOverlap> seen_;
    std::vector<Transition> changes_;
    std::vector<collision::ObjectId> candidates_;
};

}  // namespace campuswalk::engine
