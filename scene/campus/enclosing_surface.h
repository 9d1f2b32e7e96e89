#pragma once

#include <cstddef>
#include <optional>

#include "scene/campus/node_selection.h"

namespace campuswalk::scene {

/// Why a surface encloses nothing.
enum class NoInside {
    flat,       ///< it has no thickness
    open,       ///< it has openings whose rims aren't flat, as terrain does
    branching,  ///< three or more of its faces meet at an edge, or it is a strip with one side
    too_large,  ///< it has more than kMostClosedFaces faces, and isn't closed as it is
};

/// Surfaces of more faces have to be closed as they are; a trigger needs few.
inline constexpr std::size_t kMostClosedFaces = 1'000'000;

/// A surface, as far as possible one that encloses volumes and faces outward.
struct EnclosingSurface {
    WorldGeometry geometry = {};             ///< with all positions, also those that no triangle uses
    std::size_t openings = 0;                ///< that were closed
    std::size_t left_out = 0;                ///< faces of parts that enclose nothing
    std::optional<NoInside> no_inside = {};  ///< why the largest part encloses nothing
};

/// What a visitor can be inside of, where a surface is meant to enclose something and isn't quite modelled
/// so: faces that are there twice are left out, vertices within a millimetre (a ten-thousandth of the
/// surface's size, if that is less) are joined, each part is turned to face outward, and openings with a flat
/// rim are closed. Parts that enclose nothing even so are left out. What is inside of any part is inside.
EnclosingSurface enclosing_surface(const WorldGeometry& geometry);

}  // namespace campuswalk::scene
