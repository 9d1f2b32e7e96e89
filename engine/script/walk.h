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
    /// Simulated seconds for which what was looked at still counts as looked at. Columns and posts that pass
    /// before the eyes take one to ten ticks; what stays away for longer has been left.
    double gaze_hold = 0.2;
    /// What the campus' meshes are given to be queried by. It changes how long a walk takes, nothing else.
    collision::TreeKind tree = collision::TreeKind::bvh8;

    /// Rounded.
    Tick ticks_of(double seconds) const {
        return static_cast<Tick>(std::floor(seconds * ticks_per_second + 0.5));
    }
    double seconds_at(Tick tick) const { return static_cast<double>(tick) / ticks_per_second; }
    bool has_passed(double seconds, Tick ticks) const {
        constexpr double kRounding = 1e-9;  // ticks
        return static_cast<double>(ticks) >= seconds * ticks_per_second - kRounding;
    }
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
