#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "collision/geometry/ray.h"
#include "collision/geometry/triangle_mesh.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/hybrid/hybrid_tree_contacts.h"

namespace campuswalk::tools::bench {

// The interfaces of engines, and all that a peer (a third-party library) sees of the benchmark: it defines
// one or more of the functions below under their names. Meshes outlive the engines made from them, which the
// caller deletes; errors are thrown.

/// Finds which triangles of its two meshes overlap. The constructor does what is needed once for a pair of
/// meshes (trees); the rest is timed.
class Engine {
public:
    virtual ~Engine() = default;

    /// Moves b, with all that the engine must do before it can be queried again.
    virtual void set_pose(const collision::Pose& X_a_b) = 0;

    /// Replaces `out`; in any order, and with repeated pairs.
    virtual void all_pairs(std::vector<collision::TrianglePair>& out) = 0;

    /// False for an engine that can't end a search early; its first_pair isn't called.
    virtual bool stops_at_first() const { return true; }
    virtual std::optional<collision::TrianglePair> first_pair() = 0;

    /// The counts of the last query, from engines that count.
    virtual std::optional<collision::HybridContactStatistics> work() const { return std::nullopt; }
};

using MakeEngine = Engine*(const collision::TriangleMesh& a, const collision::TriangleMesh& b);
inline constexpr const char* kMakeEngine = "campuswalk_make_engine";

/// Finds the first hit of a ray.
class RayEngine {
public:
    virtual ~RayEngine() = default;

    /// The fraction of the ray at which the hit is.
    virtual std::optional<double> first_on_ray(const collision::Ray& ray) = 0;
};

using MakeRayEngine = RayEngine*(const collision::TriangleMesh& mesh);
inline constexpr const char* kMakeRayEngine = "campuswalk_make_ray_engine";

/// Finds what an avatar touches.
class TouchEngine {
public:
    virtual ~TouchEngine() = default;

    /// Replaces `out` with the triangles at most `radius` from a segment along y, ascending.
    virtual void triangles_near(const collision::Segment& upright, double radius,
                                std::vector<std::uint32_t>& out) = 0;
};

using MakeTouchEngine = TouchEngine*(const collision::TriangleMesh& mesh);
inline constexpr const char* kMakeTouchEngine = "campuswalk_make_touch_engine";

/// Builds a mesh with its tree, repeatedly, from a mesh that is already in the engine's format.
class TreeBuilder {
public:
    virtual ~TreeBuilder() = default;

    /// Stores the result, mesh included, until `discard`, which is called before the next build.
    virtual void build() = 0;
    virtual void discard() = 0;
};

using MakeTreeBuilder = TreeBuilder*(const collision::TriangleMesh& mesh);
inline constexpr const char* kMakeTreeBuilder = "campuswalk_make_tree_builder";

/// The body that walks, an upright capsule; metres, radians, seconds.
struct WalkBody {
    double radius = 0.3;
    double height = 1.8;
    double step_height = 0.3;
    double max_slope = 0.8726646259971648;  ///< 50 degrees
    double gravity = 9.81;
    double speed = 1.4;
    double tick = 1.0 / 60.0;
};

/// A character controller in a static mesh. The foot is the capsule's lowest point.
class WalkEngine {
public:
    virtual ~WalkEngine() = default;

    /// Puts the body there, at rest, and forgets its earlier motion.
    virtual void place(const collision::Vec3& foot) = 0;

    /// Walks for one tick; the desired displacement is horizontal.
    virtual void walk(const collision::Vec3& desired) = 0;

    virtual collision::Vec3 foot() const = 0;
};

using MakeWalkEngine = WalkEngine*(const collision::TriangleMesh& mesh, const WalkBody& body);
inline constexpr const char* kMakeWalkEngine = "campuswalk_make_walk_engine";
/// The same with tuned settings; the above has the library's defaults.
inline constexpr const char* kMakeTunedWalkEngine = "campuswalk_make_tuned_walk_engine";

/// How a navigation mesh is built.
struct NavMeshSettings {
    WalkBody body;
    double cell = 0.15;  ///< of its grid, metres
    double cell_height = 0.1;
    std::size_t threads = 1;
};

/// A navigation mesh: polygons that a body can walk on, computed from a static mesh.
class NavMeshEngine {
public:
    virtual ~NavMeshEngine() = default;

    /// Computes the polygons, in place of those computed earlier.
    virtual void build() = 0;

    /// Replaces `out` with the polygons, as triangles, that are linked to the one nearest to `foot`, directly
    /// or by others; with none if there is no polygon within a metre along each axis.
    virtual void reachable_from(const collision::Vec3& foot, std::vector<collision::Triangle>& out) = 0;

    /// Replaces `out` with the vertices of the way between two feet, taut within its polygons, from the first
    /// to the last point. False, and none, if there is no polygon within a metre along each axis of one of
    /// them, or if they aren't linked.
    virtual bool path(const collision::Vec3& from, const collision::Vec3& to,
                      std::vector<collision::Vec3>& out) = 0;
};

using MakeNavMeshEngine = NavMeshEngine*(const collision::TriangleMesh& mesh,
                                         const NavMeshSettings& settings);
inline constexpr const char* kMakeNavMeshEngine = "campuswalk_make_nav_mesh_engine";

}  // namespace campuswalk::tools::bench
