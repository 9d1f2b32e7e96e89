#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// An expectation whose outcome doesn't depend on what the walk does.
struct VacuousExpectation {
    SourceMark mark;
    std::string name;   ///< the code that its failure has, or would have
    bool holds = true;  ///< always; else it always fails, of a walk that is expected to
};

/// The walk's expectations, and those of its steps, that can't fail on this campus: by their numbers (`count`
/// at least 0 times), by what they can't exceed (`near` within more than the campus is wide) or because what
/// they deny can't hold. Of an xfail walk, also those that can't but fail, and times that can't but be
/// exceeded. Those that depend on what happens elsewhere aren't among them.
std::vector<VacuousExpectation> vacuous_expectations(const scene::Campus& campus, const Walk& walk);

}  // namespace campuswalk::engine
