#pragma once

#include <string>

namespace campuswalk::tools::init {

enum class Template { minimal, stairs, campus, none };

/// A model in the Wavefront format.
struct SchoolModel {
    std::string obj;  ///< an object for each mesh, in the material of its own name; names "school.mtl"
    std::string mtl;
};

/// A school in metres, +Y up, about the middle of its yard; the gate is at z = 15, south. Buildings are walls
/// 3 m high with a doorway 2 m wide to the south, and no roof, so that a plan shows what is in them.
///
/// `minimal`: terrain, library (its door at z = -6), desk. `stairs`: with a gallery 1.7 m up at the east side
/// of the yard and a flight of ten steps to it. `campus`: with cafeteria (west), gym (east) and benches, too.
/// There is none of `none`.
SchoolModel school(Template which);

}  // namespace campuswalk::tools::init
