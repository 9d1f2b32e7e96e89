#pragma once

#include "engine/simulation/stop_reason.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Why a body has no room where it is, measured: by how much headroom or width is too little, and where on
/// the ground the nearest room is. `enclosed_by`: the object that it is in.
Reason reason_of_enclosure(const scene::Campus& campus, const StoppedBody& body,
                           collision::ObjectId enclosed_by);

/// How much headroom there is instead of the body's height, and under what. None if it isn't headroom that
/// the body lacks.
std::optional<Reason> reason_of_low_headroom(const scene::Campus& campus, const StoppedBody& body);

}  // namespace campuswalk::engine
