#pragma once

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "engine/script/avatar.h"
#include "engine/script/camera.h"
#include "engine/script/expectation.h"
#include "engine/script/light.h"
#include "engine/script/step.h"
#include "scene/base/diagnostic.h"
#include "scene/model/origin.h"

namespace campuswalk::engine {

struct SimSettings {
    int ticks_per_second = 60;
    double stay_every = 1.0;  ///< simulated seconds between stay events; 0 = every tick
    /// Simulated seconds for which an object still counts as looked at. Columns and posts that pass in front
    /// of the eyes hide it for one to ten ticks; an object that is hidden for longer is no longer looked at.
    double gaze_hold = 0.2;
    /// The trees of the campus' meshes. They affect how fast a walk is simulated, nothing else.
    collision::TreeKind tree = collision::TreeKind::bvh8;
    /// A walk that takes more is stopped: a minute of standing still for the processor, nineteen days of it
    /// at 60 ticks per second.
    Tick max_ticks = 100'000'000;

    /// Rounded to the nearest tick.
    Tick ticks_of(double seconds) const {
        return static_cast<Tick>(std::floor(seconds * ticks_per_second + 0.5));
    }
    double seconds_at(Tick tick) const { return static_cast<double>(tick) / ticks_per_second; }
    bool has_passed(double seconds, Tick ticks) const {
        constexpr double kRounding = 1e-9;  // ticks
        return static_cast<double>(ticks) >= seconds * ticks_per_second - kRounding;
    }
};

/// Whether a walk is run, and whether it must fail.
struct WalkStatus {
    enum class Kind {
        run,
        skip,   ///< not run
        only,   ///< if a run has such walks, it runs no others
        xfail,  ///< must fail, with the codes given, if any
    };
    SourceMark mark;
    Kind kind = Kind::run;
    std::string reason;              ///< why it is skipped or fails
    std::vector<std::string> codes;  ///< xfail: the failures it must have, in any order; empty: any
};

/// One `NAME.walk.yaml`, resolved and checked.
struct Walk {
    std::string name;  ///< from the file's name
    SourceMark mark;
    std::string project;  ///< of walks.config.yaml; empty without
    WalkStatus status;
    std::vector<std::string> tags;  ///< kebab-case, to select walks by
    std::optional<double> timeout;  ///< simulated seconds for all steps together
    std::filesystem::path campus;   ///< the campus file, resolved
    std::string campus_name;
    scene::Origin origin;  ///< of the campus, once it is loaded
    AvatarProfile avatar;
    SimSettings sim;
    CameraSettings camera;
    Views views = default_views();  ///< one of each kind; that of `camera` has its settings
    LightSettings light;            ///< of the images
    std::vector<Step> steps;
    std::vector<std::filesystem::path>
        included;  ///< files that steps come from, in this order, each as often as it is included
    std::vector<Expectation> expectations;
};

/// Whether the walk can fail in another way than by not coming to its end; an xfail must fail somehow.
bool expects_something(const Walk& walk);

}  // namespace campuswalk::engine
