#include "tools/campuswalk_bench/explore/adversary.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>

#include "collision/geometry/trigonometry.h"
#include "collision/mover/mover.h"
#include "engine/walkspace/stride/worker_threads.h"
#include "tools/campuswalk_bench/explore/explored_campus.h"
#include "tools/campuswalk_bench/procedural/split_mix.h"

namespace campuswalk::tools::bench {

using collision::Vec3;
using engine::GridCell;
using engine::GroundState;
using engine::WalkNodeId;
using engine::WalkSpace;

namespace {

constexpr double kHighFall = 2.0;  ///< metres
constexpr double kJumpsPerSecond = 1.0;
/// Nodes are looked for in this many cells around.
constexpr int kFarthest = 40;

/// Whether a body stands within a cell and a step's height of a node.
bool is_inside(const WalkSpace& space, const Vec3& foot, double step_height) {
    const GridCell cell = space.grid.cell_at(foot);
    if (space.find(cell, foot.y(), step_height)) {
        return true;
    }
    for (int z = -1; z <= 1; ++z) {
        for (int x = -1; x <= 1; ++x) {
            if (space.find({cell.x + x, cell.z + z}, foot.y(), step_height)) {
                return true;
            }
        }
    }
    return false;
}

/// Metres to the middle of the nearest cell with a node at this height.
double distance_to_nodes(const WalkSpace& space, const Vec3& foot, double step_height) {
    const GridCell cell = space.grid.cell_at(foot);
    double least = kFarthest * space.grid.cell;
    for (int z = -kFarthest; z <= kFarthest; ++z) {
        for (int x = -kFarthest; x <= kFarthest; ++x) {
            const GridCell other{cell.x + x, cell.z + z};
            const double apart = collision::horizontal_norm(space.grid.center(other) - foot);
            if (apart < least && space.find(other, foot.y(), step_height)) {
                least = apart;
            }
        }
    }
    return least;
}

/// What the body does next.
struct Intent {
    Vec3 direction;
    engine::Gait gait = engine::Gait::walk;
};

/// Turns at random times, runs and jumps where that is allowed.
class Steering {
public:
    Steering(SplitMix& random, const engine::ExploreSettings& allowed) : random_(random), allowed_(allowed) {
        turn(3.0);
    }

    /// Of a tick; a jump is one until the body is on the ground again.
    Intent next(double seconds, bool grounded, bool steers_in_falls) {
        steer(seconds, grounded, steers_in_falls);
        if (grounded) {
            const bool jumps = allowed_.jump && random_.between(0.0, 1.0) < kJumpsPerSecond * seconds;
            gait_ = jumps ? engine::Gait::jump : runs_ ? engine::Gait::run : engine::Gait::walk;
        }
        return {direction_, gait_};
    }

private:
    void steer(double seconds, bool grounded, bool steers_in_falls) {
        left_ -= seconds;
        if (grounded && in_air_) {
            turn(3.0);  // it may have let go
        } else if (left_ <= 0.0 && (grounded || steers_in_falls)) {
            turn(grounded ? 3.0 : 0.5);
            if (!grounded && random_.between(0.0, 1.0) < 0.2) {
                direction_ = Vec3::Zero();
            }
        }
        in_air_ = !grounded && steers_in_falls;
    }

    /// Until some time has passed; short times are more frequent.
    void turn(double longest) {
        const auto angle = collision::sin_cos(random_.between(0.0, 2.0 * std::numbers::pi));
        direction_ = Vec3(angle.sin, 0.0, angle.cos);
        const double part = random_.between(0.0, 1.0);
        left_ = longest * part * part;
        runs_ = allowed_.run && random_.between(0.0, 1.0) < 0.5;
    }

    SplitMix& random_;
    const engine::ExploreSettings& allowed_;
    Vec3 direction_ = Vec3::Zero();
    engine::Gait gait_ = engine::Gait::walk;
    bool runs_ = false;
    double left_ = 0.0;
    bool in_air_ = false;
};

/// A body of a thread's own.
class Adversary {
public:
    Adversary(const WalkSpace& space, const collision::World& world, const engine::ExploreSettings& explored,
              const AdversarySettings& settings)
        : space_(space),
          settings_(settings),
          explored_(explored),
          world_(world),
          bottom_(world.bounds().min.y()),
          strider_(world, explored.strides, explored.solids) {}

    /// All nodes, by which those are numbered at which walks start.
    void walk(std::uint64_t seed, const std::vector<WalkNodeId>& nodes) {
        SplitMix random(seed);
        const std::size_t any = random.below(nodes.size());
        const WalkNodeId& first = seed % 2 == 0 ? space_.starts.front() : nodes[any];
        walk_from(space_.state_at(first, strider_), seed, random);
    }

    AdversaryResult result;

private:
    void walk_from(const GroundState& start, std::uint64_t seed, SplitMix& random) {
        const engine::StrideSettings& strides = explored_.strides;
        const collision::CapsuleMover mover(world_, strides.body, explored_.solids);
        Steering steering(random, explored_);
        collision::MoverState state;
        state.foot = start.foot;
        state.support_y = start.support_y;
        state.grounded = true;
        std::optional<Escape> escape;
        Vec3 left_ground = start.foot;
        const auto most = static_cast<std::size_t>(settings_.seconds / strides.seconds);
        for (std::size_t tick = 1; tick <= most && state.foot.y() >= bottom_; ++tick) {
            const Intent intent = steering.next(strides.seconds, state.grounded, settings_.steers_in_falls);
            const Vec3 before = state.foot;
            const bool grounded = state.grounded;
            if (grounded && intent.gait == engine::Gait::jump) {
                mover.jump(state, strides.jump_speed);
            }
            const double speed = intent.gait == engine::Gait::walk ? strides.walk_speed : strides.run_speed;
            mover.move(state, speed * strides.seconds * intent.direction, strides.seconds, cache_, trace_);
            ++result.ticks;
            result.falls += trace_.landed && trace_.fall_height > kHighFall ? 1U : 0U;
            if (grounded && !state.grounded) {
                left_ground = before;
            }
            if (state.grounded && state.foot != before &&
                !is_inside(space_, state.foot, strides.body.step_height)) {
                if (!escape) {
                    escape = Escape{seed, start.foot, tick, state.foot, left_ground, 0.0, 0};
                }
                ++escape->ticks_outside;
                escape->apart =
                    std::max(escape->apart, distance_to_nodes(space_, state.foot, strides.body.step_height));
            }
        }
        if (escape) {
            result.escapes.push_back(*escape);
        }
        ++result.walks;
    }

    const WalkSpace& space_;
    const AdversarySettings& settings_;
    const engine::ExploreSettings& explored_;
    const collision::World& world_;
    double bottom_;
    engine::Strider strider_;
    collision::MoverCache cache_;
    collision::MoveTrace trace_;
};

}  // namespace

AdversaryResult attack(const WalkSpace& space, const engine::WorkerWorlds& worlds,
                       const engine::ExploreSettings& explored, const AdversarySettings& settings) {
    AdversaryResult all;
    const std::vector<WalkNodeId> nodes = nodes_of(space);
    if (nodes.empty()) {
        return all;
    }
    std::vector<std::unique_ptr<Adversary>> adversaries;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        adversaries.push_back(std::make_unique<Adversary>(space, worlds[i], explored, settings));
    }
    engine::for_each_item(settings.walks, adversaries.size(), [&](std::size_t worker, std::size_t walk) {
        adversaries[worker]->walk(settings.first_seed + walk, nodes);
    });
    for (const auto& adversary : adversaries) {
        const AdversaryResult& one = adversary->result;
        all.walks += one.walks;
        all.ticks += one.ticks;
        all.falls += one.falls;
        all.escapes.insert(all.escapes.end(), one.escapes.begin(), one.escapes.end());
    }
    std::ranges::sort(all.escapes, [](const Escape& a, const Escape& b) {
        return a.apart != b.apart ? a.apart > b.apart : a.seed < b.seed;
    });
    return all;
}

}  // namespace campuswalk::tools::bench
