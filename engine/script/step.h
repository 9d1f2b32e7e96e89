#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "engine/events/event.h"
#include "engine/script/camera.h"
#include "engine/script/expectation.h"
#include "engine/script/mentions.h"

// The steps of a walk. `repeat` and `include` are unrolled by the loader: what is played is one plain list.
// Names are resolved by the loader: `label` is what the user wrote (a place's name, or the coordinates).

namespace campuswalk::engine {

/// What is known about a step before the run: its names and places are checked by this.
struct StepPreview {
    /// The kind of an event that the step may log, and the name in the log's object column; none: the walk's.
    struct PossibleEvent {
        EventKind kind = EventKind::walk_start;
        std::optional<std::string> object = {};
    };
    struct Place {
        std::string label;
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
    };
    struct Switch {
        std::vector<NamePattern> objects;
        bool enabled = true;
    };
    std::vector<PossibleEvent> events = {};  ///< besides those of `height` and `switched`
    std::vector<Mention> mentions = {};      ///< events that must be possible on the campus
    std::optional<Place> place = {};         ///< where the avatar is put; must be free
    std::optional<double> height = {};       ///< of the body from here on, metres
    std::optional<Switch> switched = {};     ///< objects enabled or disabled from here on
    std::vector<NamePattern> objects = {};   ///< others that must be on the campus
};

/// Places the avatar; the first step of every walk. The place must be free, which is checked before the run.
struct SpawnStep {
    SourceMark mark;
    std::string label;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double yaw = 0.0;
    bool fall = false;  ///< the walk is meant to begin with a fall: see SpawnFall

    StepPreview preview() const {
        return {.events = {{EventKind::avatar_spawn, label}, {EventKind::avatar_depenetrated, label}},
                .place = StepPreview::Place{label, position}};
    }
};

enum class IfBlocked { fail, proceed };  // YAML: fail | continue

struct WalkToStep {
    SourceMark mark;
    Target target;
    double within = 0.05;           ///< metres, horizontal
    std::optional<double> timeout;  ///< simulated seconds; default 2 x straight-line time + 5 s
    std::optional<double> speed;    ///< metres per second
    IfBlocked if_blocked = IfBlocked::fail;

    StepPreview preview() const {
        return {
            .events = {{EventKind::avatar_arrive, target.label}, {EventKind::avatar_blocked, target.label}}};
    }
};

/// What a route keeps away from: objects, or all that is around a point.
struct Avoided {
    std::optional<NamePattern> objects = {};
    Target center = {};   ///< if no objects; without a height: at any
    double radius = 0.0;  ///< metres, horizontal, of the feet
};

enum class RoutePreference : std::uint8_t {
    shortest,
    wide,  ///< a way round rather than through tight places
};

/// Along a route that is planned when the step begins, so that the avatar arrives for certain.
struct GoToStep {
    SourceMark mark;
    Target target;
    std::vector<Target> through;  ///< before it, in this order
    std::vector<Avoided> avoid;
    RoutePreference prefer = RoutePreference::shortest;
    double within = 0.05;           ///< metres, horizontal
    std::optional<double> timeout;  ///< simulated seconds; default 2 x the route's time + 5 s
    std::optional<double> speed;    ///< metres per second

    StepPreview preview() const {
        StepPreview preview{.events = {{EventKind::avatar_arrive, target.label}}};
        for (const Avoided& each : avoid) {
            if (each.objects) {
                preview.objects.push_back(*each.objects);
            }
        }
        return preview;
    }
};

struct WaitStep {
    SourceMark mark;
    double seconds = 0.0;

    StepPreview preview() const { return {}; }
};

struct TurnStep {
    SourceMark mark;
    double angle = 0.0;     ///< radians
    bool absolute = false;  ///< to the angle instead of by it

    StepPreview preview() const { return {}; }
};

struct LookAtStep {
    SourceMark mark;
    Target target;  ///< without a height: level with the eyes
    /// Index into the campus' buildings: none once resolve_targets has set the target to its middle.
    std::optional<std::size_t> building = {};

    StepPreview preview() const { return {}; }
};

struct TeleportStep {
    SourceMark mark;
    std::string label;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::optional<double> yaw;
    /// Index into the campus' places; none once resolve_targets has set the position to its own.
    std::optional<std::size_t> place = {};

    StepPreview preview() const {
        return {.events = {{EventKind::avatar_teleport, label}, {EventKind::avatar_depenetrated, label}},
                .place = StepPreview::Place{label, position}};
    }
};

/// Along a smooth curve from the avatar through points. Ends like a walk_to to the last of them.
struct FollowStep {
    SourceMark mark;
    std::vector<Target> points;     ///< at least one
    double within = 0.05;           ///< metres, horizontal, of the last point
    std::optional<double> timeout;  ///< simulated seconds; default 2 x the curve's time + 5 s
    std::optional<double> speed;    ///< metres per second
    IfBlocked if_blocked = IfBlocked::fail;

    StepPreview preview() const {
        const std::string& last = points.back().label;
        return {.events = {{EventKind::avatar_arrive, last}, {EventKind::avatar_blocked, last}}};
    }
};

/// Jumps once the avatar is on the ground; over when it has landed.
struct JumpStep {
    SourceMark mark;
    double speed = 0.0;    ///< metres per second, upwards
    double forward = 0.0;  ///< metres per second in the air, where the avatar looks

    StepPreview preview() const { return {.events = {{EventKind::avatar_jump}}}; }
};

/// Waits for an event, from the step's first tick on; ends the walk if it doesn't come.
struct WaitUntilStep {
    SourceMark mark;
    EventPattern event;
    double timeout = 30.0;  ///< simulated seconds

    StepPreview preview() const { return {.mentions = {{event, ""}}}; }
};

// Instant steps take no time: they are executed at the end of the tick that ended the step before them.

struct SnapshotStep {
    SourceMark mark;
    std::string name;  ///< file name without extension
    CameraSettings camera;
    ImageChannels channels;
    ImageOverlays overlays;

    StepPreview preview() const { return {.events = {{EventKind::snapshot_take, name}}}; }
};

/// Crouches, or stands up: a new height of the body, the eyes lowered in proportion.
struct CrouchStep {
    SourceMark mark;
    double height = 0.0;  ///< metres; the profile's own when standing up

    StepPreview preview() const { return {.height = height}; }
};

/// The speed of the following steps that don't set one.
struct SpeedStep {
    SourceMark mark;
    double speed = 0.0;  ///< metres per second

    StepPreview preview() const { return {}; }
};

/// Objects that can be touched from now on, or no longer.
struct EnableStep {
    SourceMark mark;
    std::vector<NamePattern> objects;
    bool enabled = true;

    StepPreview preview() const { return {.switched = StepPreview::Switch{objects, enabled}}; }
};

/// Ends the walk unless these expectations hold so far.
struct ExpectStep {
    SourceMark mark;
    std::vector<Expectation> expectations;  ///< at least one; no log, no images

    StepPreview preview() const { return {.mentions = mentions_of(expectations)}; }
};

using Step =
    std::variant<SpawnStep, WalkToStep, GoToStep, WaitStep, TurnStep, LookAtStep, TeleportStep, SnapshotStep,
                 FollowStep, JumpStep, WaitUntilStep, CrouchStep, SpeedStep, EnableStep, ExpectStep>;

/// Steps that take no time. Visitors may handle all of them alike.
template <typename Kind>
concept InstantStep = std::same_as<Kind, SnapshotStep> || std::same_as<Kind, CrouchStep> ||
    std::same_as<Kind, SpeedStep> || std::same_as<Kind, EnableStep> || std::same_as<Kind, ExpectStep>;

bool is_instant(const Step& step);
const SourceMark& mark_of(const Step& step);
StepPreview preview_of(const Step& step);

}  // namespace campuswalk::engine
