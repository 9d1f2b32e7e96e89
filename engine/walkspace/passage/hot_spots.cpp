#include "engine/walkspace/passage/hot_spots.h"

#include <algorithm>
#include <map>

#include "collision/world/obstacle.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

namespace {

constexpr std::size_t kHotPieces = 300;
constexpr std::size_t kMostHotSpots = 10;
constexpr double kSpotsApart = 8.0;  // metres
/// One of so many nodes is looked at.
constexpr std::size_t kEveryNode = 16;

/// What most of the pieces are of.
void attribute(const std::vector<collision::Obstacle>& pieces, HotSpot& spot) {
    std::map<collision::ObjectId, std::size_t> counts;
    std::size_t most = 0;
    for (const collision::Obstacle& piece : pieces) {
        if (const std::size_t count = ++counts[piece.object]; count > most) {
            most = count;
            spot.object = piece.object;
        }
    }
}

HotSpot hottest_of(const collision::World& world, const ExploreSettings& settings, const WalkSpace& space,
                   std::uint32_t tile) {
    const collision::MoverSettings& body = settings.strides.body;
    HotSpot hottest;
    std::vector<collision::Obstacle> near;
    for (std::size_t n = 0; n < space.tiles[tile].nodes.size(); n += kEveryNode) {
        const collision::Vec3 foot = space.position({tile, static_cast<std::uint16_t>(n)});
        collision::gather_obstacles(world, settings.solids, body.core(foot), body.radius + body.step_height,
                                    near);
        if (near.size() > std::max(hottest.pieces, kHotPieces)) {
            hottest.foot = foot;
            hottest.pieces = near.size();
            attribute(near, hottest);
        }
    }
    return hottest;
}

/// Of spots that come the hottest first.
std::vector<HotSpot> hottest_apart(const std::vector<HotSpot>& spots) {
    std::vector<HotSpot> hottest;
    for (const HotSpot& spot : spots) {
        const auto is_near = [&](const HotSpot& hotter) {
            return (hotter.foot - spot.foot).norm() < kSpotsApart;
        };
        if (hottest.size() < kMostHotSpots && std::ranges::none_of(hottest, is_near)) {
            hottest.push_back(spot);
        }
    }
    return hottest;
}

}  // namespace

std::vector<HotSpot> find_hot_spots(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                    const WalkSpace& space) {
    std::vector<HotSpot> spots(space.tiles.size());
    for_each_item(spots.size(), worlds.size(), [&](std::size_t worker, std::size_t tile) {
        spots[tile] = hottest_of(worlds[worker], settings, space, static_cast<std::uint32_t>(tile));
    });
    std::erase_if(spots, [](const HotSpot& spot) { return spot.pieces == 0; });
    std::ranges::stable_sort(spots, std::greater(), &HotSpot::pieces);
    return hottest_apart(spots);
}

}  // namespace campuswalk::engine
