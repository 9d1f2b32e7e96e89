#pragma once

#include <vector>

#include "engine/script/image_tolerance.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// An expectation that holds whatever the walk does.
struct VacuousExpectation {
    SourceMark mark;
    std::string name;  ///< the code that its failure would have
};

/// The walk's expectations, and those of its steps, that can't fail on this campus: by their numbers (`count`
/// at least 0 times), by what they can't exceed (`near` within more than the campus is wide) or because what
/// they deny can't hold. Those that depend on what happens elsewhere aren't among them.
std::vector<VacuousExpectation> vacuous_expectations(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
