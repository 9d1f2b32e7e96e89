#pragma once

#include <optional>
#include <vector>

#include "collision/hybrid_tree_contacts.h"
#include "collision/triangle_mesh.h"
#include "collision/triangle_pair.h"

namespace campuswalk::tools::bench {

/// One way to find which triangles of two meshes overlap, with both meshes in it. What happens once for a
/// pair of meshes (trees) is done by the constructor; the rest is what is timed.
class Engine {
public:
    virtual ~Engine() = default;

    /// Whatever a rigid move of b costs before it can be asked about.
    virtual void set_pose(const collision::Pose& X_a_b) = 0;

    /// Replaces `out`; any order, and a pair may be there more than once.
    virtual void all_pairs(std::vector<collision::TrianglePair>& out) = 0;

    /// False for an engine that can't end a search early: it isn't asked for its first pair.
    virtual bool stops_at_first() const { return true; }
    virtual std::optional<collision::TrianglePair> first_pair() = 0;

    /// Of the last query, by those who count it.
    virtual std::optional<collision::HybridContactCounters> work() const { return std::nullopt; }
};

/// What a peer's library has, under kMakePeer as its name. Both meshes outlive the engine, which the caller
/// deletes; whatever is wrong is thrown.
using MakePeer = Engine*(const collision::TriangleMesh& a, const collision::TriangleMesh& b);
inline constexpr const char* kMakePeer = "campuswalk_make_peer";

}  // namespace campuswalk::tools::bench
