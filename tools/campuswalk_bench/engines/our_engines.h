#pragma once

#include <memory>
#include <string>

#include "collision/geometry/triangle_mesh.h"
#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// The names of our engines: the paper's tree with each node test (paper, obb, sphere, mixed) and the BVH8
/// with each SIMD target (wide_sse42, wide_avx2, wide_avx512).
bool is_our_engine(const std::string& name);

/// One of our engines. Both meshes must outlive it. Throws std::runtime_error if this machine lacks its SIMD
/// target.
std::unique_ptr<Engine> make_our_engine(const std::string& name, const collision::TriangleMesh& a,
                                        const collision::TriangleMesh& b);

}  // namespace campuswalk::tools::bench
