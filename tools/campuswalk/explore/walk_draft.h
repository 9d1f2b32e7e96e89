#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "engine/script/avatar.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// A step of a draft, as a walk file says it.
struct DraftStep {
    enum class Kind : std::uint8_t { walk_to, go_to, wait };
    Kind kind = Kind::walk_to;
    collision::Vec3 to = collision::Vec3::Zero();  ///< feet; not of `wait`
    double seconds = 0.0;                          ///< of `wait`
    bool goes_on = false;                          ///< also if it is blocked; of `walk_to`
    std::optional<double> speed = {};              ///< metres per second, of `walk_to`; none: the avatar's
};

/// A walk of which it isn't known yet whether it shows what it is written for.
struct WalkDraft {
    collision::Vec3 spawn = collision::Vec3::Zero();  ///< feet
    std::vector<DraftStep> steps = {};
};

/// What came of a draft.
struct DraftEnd {
    std::string failure;  ///< the code of what ended it before its last step; empty: nothing did
    collision::Vec3 foot = collision::Vec3::Zero();   ///< in the end
    collision::Vec3 stood = collision::Vec3::Zero();  ///< where it last stood on the ground
    bool is_blocked = false;                          ///< a walk_to was
    bool stands_at_first = false;                     ///< on the ground, and where the spawn says
};

/// A walk that has been played, and what shows its finding.
struct ShownWalk {
    WalkDraft draft;
    std::string failure;   ///< the code of the step that fails
    collision::Vec3 goal;  ///< where it ends once the campus is mended, feet; not of a hole's
};

/// Plays drafts on a campus, exactly as `run` would play them as files.
class DraftPlayer {
public:
    /// `disabled` are globs over the objects that aren't there. The campus must outlive it.
    DraftPlayer(const scene::Campus& campus, engine::AvatarProfile avatar, std::vector<std::string> disabled);

    DraftEnd play(const WalkDraft& draft) const;

    const engine::AvatarProfile& avatar() const { return avatar_; }
    const std::vector<std::string>& disabled() const { return disabled_; }
    /// By object.
    std::vector<bool> disabled_objects() const;
    const scene::Campus& campus() const { return campus_; }

private:
    const scene::Campus& campus_;
    engine::AvatarProfile avatar_;
    std::vector<std::string> disabled_;
};

/// "[1.00000, 0.00000, -2.50000]"
std::string list_of(const collision::Vec3& p);
/// The key `steps` of a walk file.
std::string steps_yaml(const WalkDraft& draft, const std::vector<std::string>& disabled);

}  // namespace campuswalk::tools::explore
