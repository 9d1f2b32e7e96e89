#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "collision/world/obstacle.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/frontier.h"
#include "engine/walkspace/explore/known_cells.h"

namespace campuswalk::engine {

/// From this height on a fall is also steered elsewhere, and nobody walks back up, metres.
inline constexpr double kSteeredFall = 0.5;

/// A stride that a fall was steered by, and where it ended.
struct SteeredEnd {
    Stride stride;
    StrideEnd end;
};

/// A thread's body, which takes the strides of an exploration: from nodes of tiles that no other thread
/// changes meanwhile, nor the tiles around them.
class StrideWorker {
public:
    /// All of them must outlive it.
    StrideWorker(const collision::World& world, const ExploreSettings& settings, const WalkSpace& space,
                 const KnownCells& known);

    std::set<Bound> bounds;  ///< that it came upon

    /// Whether a stride in this direction would find nothing new.
    bool is_known(std::uint32_t tile, const GroundState& from, std::uint8_t direction) const;
    /// Whether a jump over clear ground in this direction may get onto something higher than a step that has
    /// no nodes yet.
    bool may_jump_up(std::uint32_t tile, const GroundState& from, std::uint8_t direction);
    /// A body that something is in the way of gives up once it can't get to a new cell any more.
    StrideEnd take(std::uint32_t tile, const GroundState& from, const Stride& stride);
    /// The fall steered elsewhere, with all ends but those at nodes. No thread may change anything meanwhile.
    std::vector<SteeredEnd> steer(std::uint32_t tile, const Fall& fall);
    /// Whether one can walk back from a stride's end to where it started.
    bool returns(const StrideEnd& end, const GroundState& start);

    Strider& strider() { return strider_; }
    const Strider& strider() const { return strider_; }
    std::uint64_t strides() const { return strides_; }  ///< taken

private:
    bool is_at_node(const StrideEnd& end) const;

    const ExploreSettings& settings_;
    const WalkSpace& space_;
    const KnownCells& known_;
    Strider strider_;
    std::vector<collision::Obstacle> ahead_;
    std::uint64_t strides_ = 0;
};

}  // namespace campuswalk::engine
