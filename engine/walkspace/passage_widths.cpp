#include "engine/walkspace/passage_widths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "collision/world/obstacle.h"
#include "engine/walkspace/node_numbers.h"
#include "engine/walkspace/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// What is farther above or below than this share of how far it is aside isn't beside.
constexpr double kHowLevelBeside = 0.5;
/// Two things are on both sides if the angle between them is at least 140 degrees: a corner isn't a passage.
constexpr double kOpposed = -0.77;

/// How far something beside the body's axis is, and where.
struct SideGap {
    double distance = 0.0;
    Vec3 direction = Vec3::Zero();  ///< level, of length 1
};

class WidthMeter {
public:
    WidthMeter(const collision::World& world, const ExploreSettings& settings, double widest)
        : world_(world), settings_(settings), widest_(widest) {}

    double at(const Vec3& foot) {
        find_gaps(foot);
        double width = widest_;
        for (std::size_t i = 0; i < gaps_.size() && 2.0 * gaps_[i].distance < width; ++i) {
            for (std::size_t j = i + 1; j < gaps_.size(); ++j) {
                const double both = gaps_[i].distance + gaps_[j].distance;
                if (both >= width) {
                    break;  // the nearest come first
                }
                if (gaps_[i].direction.dot(gaps_[j].direction) <= kOpposed) {
                    width = both;
                }
            }
        }
        return std::max(width, 2.0 * settings_.strides.body.radius);
    }

private:
    void find_gaps(const Vec3& foot) {
        const collision::MoverSettings& body = settings_.strides.body;
        const collision::Segment spine{foot + Vec3(0, 0.5 * body.height, 0), foot + Vec3(0, body.height, 0)};
        collision::gather_obstacles(world_, settings_.solids, spine, widest_ - body.radius, near_);
        gaps_.clear();
        for (const collision::Obstacle& piece : near_) {
            const collision::Closest closest = collision::closest(spine, piece);
            const Vec3 gap = closest.on_shape - closest.on_segment;
            const double aside = collision::horizontal_norm(gap);
            if (aside > 0.0 && std::abs(gap.y()) <= kHowLevelBeside * aside) {
                gaps_.push_back({aside, Vec3(gap.x(), 0.0, gap.z()) / aside});
            }
        }
        std::ranges::stable_sort(gaps_, {}, &SideGap::distance);
    }

    const collision::World& world_;
    const ExploreSettings& settings_;
    double widest_;
    std::vector<collision::Obstacle> near_;
    std::vector<SideGap> gaps_;
};

}  // namespace

std::vector<float> passage_widths(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                  const WalkSpace& space, double widest) {
    const NodeNumbers numbers(space);
    std::vector<float> widths(numbers.count());
    for_each_item(space.tiles.size(), worlds.size(), [&](std::size_t worker, std::size_t tile) {
        WidthMeter meter(worlds[worker], settings, widest);
        for (std::size_t n = 0; n < space.tiles[tile].nodes.size(); ++n) {
            const WalkNodeId id{static_cast<std::uint32_t>(tile), static_cast<std::uint16_t>(n)};
            widths[numbers(id)] = static_cast<float>(meter.at(space.position(id)));
        }
    });
    return widths;
}

}  // namespace campuswalk::engine
