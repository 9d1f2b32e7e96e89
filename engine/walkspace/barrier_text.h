#pragma once

#include <string>

#include "engine/walkspace/why_not.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What it is called in files: "riser", "ledge", "slope", "opening", "headroom", "object", "several",
/// "solid", "gap", "sequence".
const char* name_of(BarrierKind kind);

/// The object's id and the node at that point that it comes from, if its name says more: "stair (step-1)".
std::string object_text(const scene::Campus& campus, collision::ObjectId object, const collision::Vec3& at);

/// As a sentence without its full stop: "riser of 0.45 m at stair (step-1), 3.20, 0.45, -1.00; the avatar
/// steps 0.30 m". Of a sequence: "riser of 0.45 m at …, then riser of 0.50 m at …; the avatar steps 0.30 m".
std::string barrier_text(const scene::Campus& campus, const Barrier& barrier);

}  // namespace campuswalk::engine
