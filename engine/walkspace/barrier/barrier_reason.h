#pragma once

#include <string>

#include "engine/events/reason.h"
#include "engine/walkspace/barrier/why_not.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What it is called in files: "riser", "ledge", "slope", "opening", "headroom", "object", "several",
/// "solid", "gap", "sequence".
std::string_view name_of(BarrierKind kind);

/// Of this kind, about the object at that point, with the node there that it comes from.
Reason reason_about(ReasonKind kind, const scene::Campus& campus, collision::ObjectId object,
                    const collision::Vec3& at);

/// "stair (step-1)": the object's id and the node at that point, if its name says more.
std::string object_text(const scene::Campus& campus, collision::ObjectId object, const collision::Vec3& at);

/// A barrier in terms of the campus's files.
Reason reason_of(const scene::Campus& campus, const Barrier& barrier);

}  // namespace campuswalk::engine
