#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/world/broad_phase.h"
#include "engine/events/reason.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"
#include "scene/campus/node_triangles.h"

namespace campuswalk::engine {

/// A measured reason why the body doesn't get somewhere.
struct Barrier {
    ReasonKind kind = ReasonKind::solid;           ///< one of those that are about a passage
    double measured = 0.0;                         ///< what the body would have to manage; slopes in radians
    double allowed = 0.0;                          ///< what it manages
    collision::Vec3 at = collision::Vec3::Zero();  ///< where it was stopped, on the barrier
    collision::Vec3 from = collision::Vec3::Zero();  ///< where it stood then, feet
    std::optional<collision::ObjectId> object;       ///< what it touched there, or what stands in the way
    std::uint32_t triangle = 0;                      ///< of the object's mesh
    bool is_node = false;  ///< of kind `object`: only the node that has the triangle, not all of the object
    /// Other changes, each of which would do as well, the smaller first; of `several`, all that it takes; of
    /// `sequence` too, in the order in which a visitor comes upon them. Its place is that of the first.
    std::vector<Barrier> parts = {};
};

/// Whether it names one change that lets the body through: where it leads to, one could be led on from.
bool is_one_change(ReasonKind kind);

/// Which changes are tried.
enum class Changes : std::uint8_t {
    any,
    single,  ///< not several at once, which is slow
    body,    ///< only one of the body, with steps up to kHighestRiser: quick where nothing helps
    climbs,  ///< only a step up to kHighestRiser, or a slope
};

/// From where to where the body doesn't get.
struct PassageQuery {
    std::vector<GroundState> from;
    /// Whether a node in this cell, at this height, is beyond the barrier.
    std::function<bool(const GridCell&, double y)> is_beyond;
    std::optional<collision::Vec3> middle = {};  ///< of what is beyond: of like objects, the one on the way
    collision::Aabb within;                      ///< where to look for ways, horizontally and vertically
    /// Where the body got to, and further ground on which no way is looked for, of one grid. May be empty.
    std::vector<const WalkSpace*> known = {};
    const scene::NodeTriangles* nodes = nullptr;  ///< what meshes consist of; may be null
    /// Whether solids surround what is beyond, so that no body gets there: asked only where no single change
    /// helps. May be empty.
    std::function<bool()> is_enclosed = {};
    /// How high the step up to what is beyond probably is, metres: saves searches where that is right.
    std::optional<double> likely_riser = {};
    Changes changes = Changes::any;
    double longest_crossing = 6.0;  ///< a way across the barrier is no longer than this, metres
    bool steer_falls = false;       ///< see ExploreSettings: of the body as it is
};

/// The body gets there as it is.
struct Passable {};
/// Only climbs were tried, and none helps.
struct Unexplained {};
using WhyNot = std::variant<Barrier, Passable, Unexplained>;

/// The smallest change that would let the body through: of its step, its slope, its width or its height, or
/// one object or node less. Found by walking with a changed body, measured to a millimetre and a tenth of a
/// degree.
WhyNot why_not(const WorkerWorlds& worlds, const ExploreSettings& settings, const PassageQuery& query);

/// None both if the body gets there after all and if nothing was found out: there is nothing to say of
/// either.
std::optional<Barrier> barrier_in(WhyNot answer);

/// A ledge higher than this is climbed by no one, metres.
inline constexpr double kHighestLedge = 3.0;
/// What is called a riser and not a ledge, metres.
inline constexpr double kHighestRiser = 0.6;

}  // namespace campuswalk::engine
