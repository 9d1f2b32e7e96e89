#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

struct NamedEngine {
    std::string name;
    bool is_ours = false;
    std::unique_ptr<Engine> engine;
};

struct PairEngines {
    std::vector<NamedEngine> engines;
    std::vector<std::string> absent;  ///< one line per engine: its name, and why it is absent
};

/// Makes the engines of `names`, ours or peers' (peer_engines.h), that this machine can run, in that order.
/// Both meshes must outlive them.
PairEngines make_engines(const collision::TriangleMesh& a, const collision::TriangleMesh& b,
                         std::span<const char* const> names);

}  // namespace campuswalk::tools::bench
