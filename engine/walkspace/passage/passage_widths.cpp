#include "engine/walkspace/passage/passage_widths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "collision/world/obstacle.h"
#include "engine/walkspace/space/node_numbers.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

/// What is farther above or below than this share of how far it is aside isn't beside.
constexpr double kHowLevelBeside = 0.5;
/// Two things are on both sides if the angle between them is at least 120 degrees: a corner isn't a passage,
/// but a doorway in a thin wall is one, though nodes lie half a cell before and behind the wall.
constexpr double kOpposed = -0.5;
/// The middle of a body's cell is no nearer to what is on one side than this share of its radius.
constexpr double kNearestSide = 0.4;
/// From where a body stands, a share of its radius that leads into no wall.
constexpr double kStaysOutside = 0.8;

/// Something beside the body's axis.
struct SideGap {
    double distance = 0.0;          ///< from the axis, metres
    Vec3 direction = Vec3::Zero();  ///< level, of length 1
    PassageSide side;
};

class WidthMeter {
public:
    WidthMeter(const collision::World& world, const ExploreSettings& settings, double widest)
        : world_(world), settings_(settings), widest_(widest) {}

    /// None if it isn't less than the widest.
    std::optional<PassageWidth> at(const Vec3& foot) {
        find_gaps(foot);
        std::optional<PassageWidth> narrowest;
        double width = widest_;
        for (std::size_t i = 0; i < gaps_.size() && 2.0 * gaps_[i].distance < width; ++i) {
            for (std::size_t j = i + 1; j < gaps_.size(); ++j) {
                const double both = gaps_[i].distance + gaps_[j].distance;
                if (both >= width) {
                    break;  // the nearest come first
                }
                if (gaps_[i].direction.dot(gaps_[j].direction) <= kOpposed) {
                    width = both;
                    narrowest = {foot, width, {gaps_[i].side, gaps_[j].side}};
                }
            }
        }
        return narrowest;
    }

    /// Whether the body fits in where it was measured last.
    bool had_room() const {
        constexpr double kTight = 0.01;
        return gaps_.empty() || gaps_.front().distance >= settings_.strides.body.radius - kTight;
    }

private:
    void find_gaps(const Vec3& foot) {
        const collision::MoverSettings& body = settings_.strides.body;
        // It ends at the middle of the head, where the body is still as wide as elsewhere.
        const collision::Segment spine{foot + Vec3(0, 0.5 * body.height, 0),
                                       foot + Vec3(0, body.height - body.radius, 0)};
        const double farthest = widest_ - kNearestSide * body.radius;
        collision::gather_obstacles(world_, settings_.solids, spine, farthest, near_);
        gaps_.clear();
        for (const collision::Obstacle& piece : near_) {
            const collision::Closest closest = collision::closest(spine, piece);
            const Vec3 gap = closest.on_shape - closest.on_segment;
            const double aside = collision::horizontal_norm(gap);
            if (aside > 0.0 && std::abs(gap.y()) <= kHowLevelBeside * aside) {
                gaps_.push_back(
                    {aside, Vec3(gap.x(), 0.0, gap.z()) / aside, {piece.object, closest.on_shape}});
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
    const double own = 2.0 * settings.strides.body.radius;
    std::vector<float> widths(numbers.count());
    for_each_item(space.tiles.size(), worlds.size(), [&](std::size_t worker, std::size_t tile) {
        WidthMeter meter(worlds[worker], settings, widest);
        for (std::size_t n = 0; n < space.tiles[tile].nodes.size(); ++n) {
            const WalkNodeId id{static_cast<std::uint32_t>(tile), static_cast<std::uint16_t>(n)};
            const std::optional<PassageWidth> passage = meter.at(space.position(id));
            widths[numbers(id)] = static_cast<float>(std::max(passage ? passage->width : widest, own));
        }
    });
    return widths;
}

std::optional<PassageWidth> narrowest_near(const collision::World& world, const ExploreSettings& settings,
                                           const Vec3& foot, double widest) {
    constexpr double kLeastMove = 5e-4;
    const double farthest = kStaysOutside * settings.strides.body.radius;
    WidthMeter meter(world, settings, widest);
    std::optional<PassageWidth> narrowest = meter.at(foot);
    for (double move = 0.5 * farthest; narrowest && move >= kLeastMove;) {
        const Vec3 from = narrowest->foot;
        for (const GridDirection& to : grid_directions()) {
            const Vec3 aside = from + move * to.unit;
            const bool is_near = collision::horizontal_norm(aside - foot) <= farthest;
            const auto other = is_near ? meter.at(aside) : std::nullopt;
            if (other && other->width < narrowest->width && meter.had_room()) {
                narrowest = other;
            }
        }
        if (narrowest->foot == from) {
            move *= 0.5;
        }
    }
    return narrowest;
}

}  // namespace campuswalk::engine
