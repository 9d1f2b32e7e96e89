#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "engine/script/avatar.h"
#include "engine/script/camera.h"
#include "engine/script/expectation.h"
#include "engine/script/light.h"
#include "engine/script/mentions.h"
#include "scene/base/diagnostic.h"
#include "scene/model/origin.h"

namespace campuswalk::engine {

// ---- images -----------------------------------------------------------------------------------------

/// What else of an image is kept, as files of numbers.
struct ImageChannels {
    bool depth = false;
    bool ids = false;  ///< which building and object each pixel shows
    bool normals = false;

    bool any() const { return depth || ids || normals; }
};

/// What is drawn over an image, for whoever wants to see how the campus works.
struct ImageOverlays {
    bool path = false;                   ///< the way walked so far
    bool contacts = false;               ///< where something solid was touched
    bool colliders = false;              ///< edges of what is solid or seen
    bool triggers = false;               ///< edges of what notices who is inside
    bool labels = false;                 ///< titles of the buildings that are in the image
    bool compass = false;                ///< where north is
    std::optional<int> tree_level = {};  ///< the boxes at this level of the meshes' trees, 0 the whole mesh'

    bool any_lines() const { return path || contacts || colliders || triggers || tree_level; }
};

// ---- steps --------------------------------------------------------------------------------------------
// `repeat` and `include` are unrolled by the loader: what is played is one plain list.
// Names are resolved by the loader: `label` is what the user wrote (a place's name, or the coordinates).

/// Puts the avatar down; the first step of every walk. The place must be free: it is checked before the run.
struct SpawnStep {
    SourceMark mark;
    std::string label;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double yaw = 0.0;
};

enum class IfBlocked { fail, proceed };  // YAML: fail | continue

struct WalkToStep {
    SourceMark mark;
    Target target;
    double within = 0.05;           ///< metres, horizontal
    std::optional<double> timeout;  ///< simulated seconds; default 2 x straight-line time + 5 s
    std::optional<double> speed;    ///< metres a second
    IfBlocked if_blocked = IfBlocked::fail;
};

struct WaitStep {
    SourceMark mark;
    double seconds = 0.0;
};

struct TurnStep {
    SourceMark mark;
    double angle = 0.0;     ///< radians
    bool absolute = false;  ///< to the angle instead of by it
};

struct LookAtStep {
    SourceMark mark;
    Target target;  ///< without a height: level with the eyes
};

struct TeleportStep {
    SourceMark mark;
    std::string label;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::optional<double> yaw;
};

/// Along a smooth curve through points, from where the avatar is. Ends like a walk_to to the last of them.
struct FollowStep {
    SourceMark mark;
    std::vector<Target> points;     ///< at least one
    double within = 0.05;           ///< metres, horizontal, of the last point
    std::optional<double> timeout;  ///< simulated seconds; default 2 x the curve's time + 5 s
    std::optional<double> speed;    ///< metres a second
    IfBlocked if_blocked = IfBlocked::fail;
};

/// Once on the ground, up; over when it is on the ground again.
struct JumpStep {
    SourceMark mark;
    double speed = 0.0;    ///< metres a second, upwards
    double forward = 0.0;  ///< metres a second in the air, where the avatar looks
};

/// Waits for an event from the step's first tick on; ends the walk if it doesn't come.
struct WaitUntilStep {
    SourceMark mark;
    EventPattern event;
    double timeout = 30.0;  ///< simulated seconds
};

// Instant steps take no time: they are carried out at the end of the tick that ended the step before them.

struct SnapshotStep {
    SourceMark mark;
    std::string name;  ///< file name without extension
    CameraSettings camera;
    ImageChannels channels;
    ImageOverlays overlays;
};

/// Crouches, or stands up: a new height of the body, the eyes lowered in proportion.
struct CrouchStep {
    SourceMark mark;
    double height = 0.0;  ///< metres; the profile's own when standing up
};

/// The pace of what follows, where a step has no speed of its own.
struct SpeedStep {
    SourceMark mark;
    double speed = 0.0;  ///< metres a second
};

/// Objects that can be met from now on, or no longer.
struct EnableStep {
    SourceMark mark;
    std::vector<NamePattern> objects;
    bool enabled = true;
};

/// Ends the walk unless all has been as expected so far.
struct ExpectStep {
    SourceMark mark;
    std::vector<Expectation> expectations;  ///< at least one; no log, no images
};

using Step = std::variant<SpawnStep, WalkToStep, WaitStep, TurnStep, LookAtStep, TeleportStep, SnapshotStep,
                          FollowStep, JumpStep, WaitUntilStep, CrouchStep, SpeedStep, EnableStep, ExpectStep>;

/// Whatever visits steps handles those that take no time as one kind, and each of the others by itself.
template <typename Kind>
concept InstantStep = std::same_as<Kind, SnapshotStep> || std::same_as<Kind, CrouchStep> ||
    std::same_as<Kind, SpeedStep> || std::same_as<Kind, EnableStep> || std::same_as<Kind, ExpectStep>;

inline bool is_instant(const Step& step) {
    return std::visit([]<typename Kind>(const Kind&) { return InstantStep<Kind>; }, step);
}

inline const SourceMark& mark_of(const Step& step) {
    return std::visit([](const auto& each) -> const SourceMark& { return each.mark; }, step);
}

// ---- the walk -----------------------------------------------------------------------------------------

struct SimSettings {
    int ticks_per_second = 60;
    double stay_every = 1.0;  ///< simulated seconds between stay events; 0 = every tick
    /// Simulated seconds for which what was looked at still counts as looked at. Columns and posts that pass
    /// before the eyes take one to ten ticks; what stays away for longer has been left.
    double gaze_hold = 0.2;
    /// What the campus' meshes are given to be queried by. It changes how long a walk takes, nothing else.
    collision::TreeKind tree = collision::TreeKind::bvh8;
};

/// What is to be done with a walk, and what is to be thought of its end.
struct WalkStatus {
    enum class Kind {
        run,
        skip,   ///< not run
        only,   ///< where a run has such walks, it has no others
        xfail,  ///< must fail, for the reasons named if any are
    };
    SourceMark mark;
    Kind kind = Kind::run;
    std::string reason;              ///< why it is skipped or fails
    std::vector<std::string> codes;  ///< xfail: the failures it must have, in any order; empty: some
};

/// One `NAME.walk.yaml`, resolved and checked.
struct Walk {
    std::string name;  ///< from the file's name
    SourceMark mark;
    std::string project;  ///< which of walks.config.yaml it is played for; empty without
    WalkStatus status;
    std::vector<std::string> tags;  ///< kebab-case, to select walks by
    std::optional<double> timeout;  ///< simulated seconds for all steps together
    std::filesystem::path campus;   ///< the campus file, resolved
    std::string campus_name;
    scene::Origin origin;  ///< the campus', once that is loaded
    AvatarProfile avatar;
    SimSettings sim;
    CameraSettings camera;
    Views views = default_views();  ///< as `camera` has them, for whoever takes another than its own
    LightSettings light;            ///< of its images
    std::vector<Step> steps;
    std::vector<Expectation> expectations;
};

}  // namespace campuswalk::engine
