#pragma once

#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// Warnings about the scenes that make up most of a campus, where what people build alike in them has an
/// unusual size, or seems to lie on its back: the codes odd-scale and z-up, at the scene's line.
std::vector<scene::Diagnostic> frame_hints(const scene::Campus& campus);

}  // namespace campuswalk::tools
