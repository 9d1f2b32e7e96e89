#pragma once

#include <cstddef>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A node that is drawn, or was only worked with, and that nobody stands on or runs into.
struct IntangibleNode {
    enum class Kind {
        sky,     ///< a dome, ball or box around everything, or clouds above it
        water,   ///< level, and named so
        operand  ///< a box that an opening was cut with, named so
    };
    std::size_t node = 0;
    Kind kind = Kind::sky;
};

/// Finds, in order of nodes, those that have a name of their own and nothing below them, so that a campus can
/// leave them out by a glob; +Y is up. A sky is recognized by its shape, if it surrounds everything else, or
/// by a name and its place.
std::vector<IntangibleNode> intangible_nodes(const Model& model);

}  // namespace campuswalk::scene
