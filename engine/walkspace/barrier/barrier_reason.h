#pragma once

#include <string>

#include "engine/events/reason.h"
#include "engine/walkspace/barrier/why_not.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Whether a single barrier of this kind has a number.
bool has_measure(ReasonKind kind);

/// Of this kind, about the object at that point, with the node there that it comes from.
Reason reason_about(ReasonKind kind, const scene::Campus& campus, collision::ObjectId object,
                    const collision::Vec3& at);

/// "stair (step-1)": the object's id and the node at that point, if its name says more.
std::string object_text(const scene::Campus& campus, collision::ObjectId object, const collision::Vec3& at);

/// A barrier in terms of the campus's files.
Reason reason_of(const scene::Campus& campus, const Barrier& barrier);

}  // namespace campuswalk::engine
