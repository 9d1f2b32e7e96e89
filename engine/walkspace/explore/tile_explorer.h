#pragma once

#include <cstdint>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/frontier.h"
#include "engine/walkspace/explore/growing_space.h"
#include "engine/walkspace/explore/stride_worker.h"

namespace campuswalk::engine {

/// A worker in a tile, from whose nodes it takes strides; what these lead to is added. Others work on tiles
/// farther away.
class TileExplorer {
public:
    /// All of them must outlive it.
    TileExplorer(const ExploreSettings& settings, GrowingSpace& growing, std::uint32_t tile,
                 StrideWorker& worker)
        : settings_(settings), growing_(growing), tile_(tile), worker_(worker) {}

    /// Takes the strides that are due before `limit`.
    void explore(std::uint32_t limit);
    /// Adds what a stride led to that the worker took from the tile.
    void note(const Pending& from, const Stride& stride, const StrideEnd& end);

private:
    void stride_from(Pending from);
    StrideEnd try_stride(const Pending& from, const Stride& stride);
    /// Onto what lies ahead, over clear ground: what is high is got onto at the height of a jump. Jumps out
    /// of the world don't count: they lead over an edge that is nearer to other nodes.
    void jump_from(const Pending& from);

    const ExploreSettings& settings_;
    GrowingSpace& growing_;
    std::uint32_t tile_;
    StrideWorker& worker_;
};

}  // namespace campuswalk::engine
