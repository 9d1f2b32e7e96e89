#pragma once

#include <string>
#include <vector>

#include "tools/campuswalk/bench/our_engines.h"

namespace campuswalk::tools::bench {

struct Peers {
    std::vector<NamedEngine> engines;
    std::vector<std::string> absent;  ///< a line each: which, and why
};

/// Other people's engines: those whose libraries lie in the folder `peers` beside this program. The program
/// links none of them. Both meshes must outlive them.
Peers load_peers(const collision::TriangleMesh& a, const collision::TriangleMesh& b);

}  // namespace campuswalk::tools::bench
