#pragma once

#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Where a walk was when something was not as expected.
struct FailureScene {
    Tick tick = 0;
    double time = 0.0;                                   ///< seconds
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< foot point, metres
    double yaw = 0.0;                                    ///< radians
    double pitch = 0.0;                                  ///< radians
    std::string building;                  ///< whose window is open or that is nearest; may be empty
    std::string nearest;                   ///< the nearest object's id, empty when none is near
    double nearest_distance = 0.0;         ///< metres, from the body
    std::vector<std::string> last_events;  ///< as the text log prints them, oldest first
};

/// Why a walk did not pass: a step that gave up or an expectation that was not met.
struct Failure {
    SourceMark mark;      ///< the step or expectation in the walk file
    std::string code;     ///< one of failure_codes(), or "xfail": should have failed and did not
    std::string message;  ///< what was expected and what came instead, on a line
    FailureScene scene = {};
};

}  // namespace campuswalk::engine
