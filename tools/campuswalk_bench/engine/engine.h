#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/geometry/ray.h"
#include "collision/geometry/triangle_mesh.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/hybrid/hybrid_tree_contacts.h"

namespace campuswalk::tools::bench {

// What engines are asked. All that a peer, a library of other people's, sees of the benchmark: it has one or
// more of the functions below under their names. Meshes outlive what is made of them, which the caller
// deletes; whatever is wrong is thrown.

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
    virtual std::optional<collision::HybridContactStatistics> work() const { return std::nullopt; }
};

using MakeEngine = Engine*(const collision::TriangleMesh& a, const collision::TriangleMesh& b);
inline constexpr const char* kMakeEngine = "campuswalk_make_engine";

/// One way to find what a ray meets first.
class RayEngine {
public:
    virtual ~RayEngine() = default;

    /// The fraction of the ray at which it is.
    virtual std::optional<double> first_on_ray(const collision::Ray& ray) = 0;
};

using MakeRayEngine = RayEngine*(const collision::TriangleMesh& mesh);
inline constexpr const char* kMakeRayEngine = "campuswalk_make_ray_engine";

/// One way to find what an avatar touches.
class TouchEngine {
public:
    virtual ~TouchEngine() = default;

    /// Replaces `out` by the triangles no farther than `radius` from a segment along y, ascending.
    virtual void triangles_near(const collision::Segment& upright, double radius,
                                std::vector<std::uint32_t>& out) = 0;
};

using MakeTouchEngine = TouchEngine*(const collision::TriangleMesh& mesh);
inline constexpr const char* kMakeTouchEngine = "campuswalk_make_touch_engine";

/// A mesh with its tree, made as often as asked from a mesh that is in the engine's own format already.
class TreeBuilder {
public:
    virtual ~TreeBuilder() = default;

    /// Keeps what it makes, mesh included, until `discard`, which comes before another build.
    virtual void build() = 0;
    virtual void discard() = 0;
};

using MakeTreeBuilder = TreeBuilder*(const collision::TriangleMesh& mesh);
inline constexpr const char* kMakeTreeBuilder = "campuswalk_make_tree_builder";

/// Who walks: an upright capsule, metres, radians, seconds.
struct WalkBody {
    double radius = 0.3;
    double height = 1.8;
    double step_height = 0.3;
    double max_slope = 0.8726646259971648;  ///< 50 degrees
    double gravity = 9.81;
    double speed = 1.4;
    double tick = 1.0 / 60.0;
};

/// A character controller in a mesh that stands still. The foot is the capsule's lowest point.
class WalkEngine {
public:
    virtual ~WalkEngine() = default;

    /// Puts the body there, at rest; what was before makes no difference from now on.
    virtual void place(const collision::Vec3& foot) = 0;

    /// Walks for a tick: `wish` is the displacement asked for, level.
    virtual void walk(const collision::Vec3& desired) = 0;

    virtual collision::Vec3 foot() const = 0;
};

using MakeWalkEngine = WalkEngine*(const collision::TriangleMesh& mesh, const WalkBody& body);
inline constexpr const char* kMakeWalkEngine = "campuswalk_make_walk_engine";
/// The same set up as well as it can be; the above has the library's defaults.
inline constexpr const char* kMakeTunedWalkEngine = "campuswalk_make_tuned_walk_engine";

}  // namespace campuswalk::tools::bench
