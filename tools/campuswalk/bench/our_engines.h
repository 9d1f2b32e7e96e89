#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision/triangle_mesh.h"
#include "tools/campuswalk/bench/engine.h"

namespace campuswalk::tools::bench {

struct NamedEngine {
    std::string name;
    bool is_ours = false;
    std::unique_ptr<Engine> engine;
};

/// The paper's tree with each node test (paper, obb, sphere, mixed), then the wide tree with each instruction
/// set that this machine has. Both meshes must outlive them.
std::vector<NamedEngine> our_engines(const collision::TriangleMesh& a, const collision::TriangleMesh& b);

}  // namespace campuswalk::tools::bench
