#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/events/event.h"
#include "engine/events/reason.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// The state of a walk when it failed.
struct FailureScene {
    Tick tick = 0;
    double time = 0.0;                                   ///< seconds
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< foot point, metres
    double yaw = 0.0;                                    ///< radians
    double pitch = 0.0;                                  ///< radians
    std::string building;           ///< the one with an open window or the nearest; may be empty
    std::string nearest;            ///< the nearest object's id; empty if none is near
    double nearest_distance = 0.0;  ///< metres, from the body
    /// What to look at: where the reason was measured, or what the body touches or nearly touches.
    std::optional<Eigen::Vector3d> contact = {};
    std::vector<std::string> last_events;  ///< as the text log prints them, oldest first
};

/// Why a walk did not pass: a step that gave up or an expectation that doesn't hold.
struct Failure {
    SourceMark mark;      ///< the step or expectation in the walk file
    std::string code;     ///< one of failure_codes() or of those in failure_codes.h
    std::string message;  ///< one line: what was expected and what happened instead
    FailureScene scene = {};
    // The facts that the message words, as far as there are any.
    std::optional<Reason> reason = {};    ///< what kept the avatar from where it should have got
    std::string object = {};              ///< the one that it is about: in the way, or of an event
    std::optional<RouteHint> route = {};  ///< a route to where it should have got
    std::string actual = {};              ///< what happened, if the message puts it in so few words
    std::string expected = {};            ///< instead of that
};

}  // namespace campuswalk::engine
