#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/function_ref.h"
#include "collision/mover/mover.h"
#include "engine/walkspace/stride/walk_grid.h"

namespace campuswalk::engine {

/// How the body moves during a stride.
enum class Gait : std::uint8_t { walk, run, jump };

/// A straight walk of about one cell: what the walk space is explored by. A body that leaves the ground goes
/// on in the same direction until it lands, or is steered elsewhere.
struct Stride {
    static constexpr std::uint8_t kStraightOn = 8;  ///< in a fall: as on the ground
    static constexpr std::uint8_t kLetGo = 9;       ///< in a fall: straight down

    std::uint8_t direction = 0;  ///< index into grid_directions()
    Gait gait = Gait::walk;
    std::uint8_t steering = kStraightOn;  ///< in a fall: an index into grid_directions(), or one of these
    std::uint8_t steers_after = 0;        ///< in a fall: fifths of a second straight on before that

    friend bool operator==(const Stride&, const Stride&) = default;
};

/// Where a body stands: all that its next move on the ground depends on.
struct GroundState {
    collision::Vec3 foot = collision::Vec3::Zero();
    double support_y = 0.0;  ///< see collision::MoverState

    friend bool operator==(const GroundState&, const GroundState&) = default;
};

/// What a stride ended in.
struct StrideEnd {
    enum class Kind : std::uint8_t {
        grounded,  ///< on the ground
        gone,      ///< it fell out of the world, or nothing is left that it could land on
        falling,   ///< still in the air after kMaxFall seconds, or caught there
    };
    Kind kind = Kind::grounded;
    GroundState at;        ///< if it stands
    collision::Vec3 edge;  ///< if it left the ground: where it last stood, at the height of what carried it
    bool left_ground = false;
    bool given_up = false;  ///< half-way, on the ground: see Strider::take
    /// Nothing was in the way, no step climbed, no edge passed: the way back is free as well.
    bool clean = true;
    int ticks = 0;
    int ticks_ahead = 0;  ///< of them, of a stride: before it was steered elsewhere
};

/// A fall that takes longer isn't followed, seconds: 4.4 km.
inline constexpr double kMaxFall = 30.0;

/// Where a body that stands would fall from: one that hangs over an edge is lower than that already.
collision::Vec3 edge_below(const collision::MoverState& state);
/// Of a body that stands.
collision::MoverState state_of(const GroundState& at);

/// The body that strides, and how fast, per tick of `seconds`.
struct StrideSettings {
    collision::MoverSettings body;
    /// Of a body that has crouched and may stand up: its full height, metres. It is put down with that.
    std::optional<double> full_height = {};
    double seconds = 1.0 / 60.0;
    double walk_speed = 1.4;  ///< metres per second
    double run_speed = 2.8;
    double jump_speed = 2.8;  ///< metres per second upwards, at take-off

    /// The body where it has headroom, see Strider::has_headroom.
    collision::MoverSettings upright_body() const;
};

double jump_height(const StrideSettings& settings);  ///< metres
/// How far ahead a jump may touch ground as high as where it started, metres.
double jump_length(const StrideSettings& settings);

/// A body in a world, for one thread. Each stride depends on its arguments alone.
class Strider {
public:
    /// The world, and what `filter` points to, must outlive it.
    Strider(const collision::World& world, const StrideSettings& settings,
            const collision::QueryFilter& filter);

    /// Falls end where they leave this box, as if out of the world: for searches that end there as well.
    void limit_falls(const collision::Aabb& box) { fall_limits_ = box; }

    /// Whether a body that stands there may get somewhere that is worth it with so many metres more.
    using IsWorthIt = collision::FunctionRef<bool(const GroundState& at, double metres)>;

    /// Towards the middle of the next cell in the stride's direction.
    StrideEnd take(const GroundState& from, const Stride& stride, const WalkGrid& grid);
    /// Likewise, but a body that something is in the way of gives up once it isn't worth going on.
    StrideEnd take(const GroundState& from, const Stride& stride, const WalkGrid& grid,
                   const IsWorthIt& is_worth_it);
    /// Towards a point, as the step walk_to goes, for at most `seconds`: ends on the ground within `within`
    /// of it, horizontally, or at a standstill. TrialWalk arrives exactly as the step does.
    StrideEnd walk_to(const GroundState& from, const collision::Vec3& point, double within, double seconds);
    /// Puts the body down as a spawn does, and lets it fall to the ground. Gone if there is no free place, or
    /// no ground.
    StrideEnd put_down(const collision::Vec3& foot);

    /// Whether the body hangs over an edge: what carries it is higher beside it than any ground is that it
    /// stands on.
    bool hangs(const GroundState& at) const;
    /// Whether a body that has crouched has room to stand up; true for others.
    bool has_headroom(const GroundState& at);

    /// The next stride shares nothing with the last one.
    void forget_last_stride() { shared_.forks.clear(); }
    /// Gives memory back that was only needed in dense surroundings. Nothing is found otherwise for it.
    void forget_dense_surroundings();

    /// The feet at the end of each tick of the last stride.
    const std::vector<collision::Vec3>& path() const { return path_; }
    /// By object: whether any stride was obstructed where it touched it.
    const std::vector<bool>& touched() const { return touched_; }
    std::uint64_t ticks() const { return ticks_; }  ///< of all strides

    const StrideSettings& settings() const { return settings_; }
    const collision::World& world() const { return *world_; }
    const collision::QueryFilter& filter() const { return filter_; }

private:
    /// How far the strides go together that leave the ground alike and are steered elsewhere later.
    struct SharedFall {
        GroundState from;
        std::uint8_t direction = 0;
        Gait gait = Gait::walk;
        double cell = 0.0;  ///< of the grid
        StrideEnd end;      ///< as the body leaves the ground
        /// One for each fifth of a second in the air, from the first tick there on.
        struct Fork {
            std::size_t ticks = 0;  ///< of the stride, so far
            collision::MoverState state;
            int obstructed_ticks = 0;
        };
        std::vector<Fork> forks;  ///< empty: none is known
    };

    void start(const GroundState& from);
    void walk_ahead(const collision::Vec3& desired, int most, double level_rise, const IsWorthIt& is_worth_it,
                    StrideEnd& end);
    bool shares_fall(const GroundState& from, const Stride& stride, const WalkGrid& grid) const;
    void note_fork();
    void tick(const collision::Vec3& desired);
    void fall_ahead(const collision::Vec3& ahead, std::size_t fifths);
    void fall(const collision::Vec3& desired, std::size_t ticks);
    void fall_for_a_tick(const collision::Vec3& desired);
    bool is_caught(std::size_t ticks) const;
    bool is_falling() const { return !state_.grounded && state_.foot.y() >= bottom_; }
    std::size_t ticks_in(std::size_t fifths) const;
    bool falls_out_of_the_world(const collision::Vec3& desired);
    bool is_free(const collision::Aabb& box);
    double seconds_to_bottom(const collision::Vec3& foot, double speed) const;
    void finish(StrideEnd& end) const;
    double speed_of(Gait gait) const;

    const collision::World* world_;
    StrideSettings settings_;
    collision::QueryFilter filter_;
    double bottom_;  ///< below this nothing is left to land on
    std::optional<collision::Aabb> fall_limits_;
    double steepest_rise_;  ///< per metre ahead, on walkable ground
    collision::CapsuleMover mover_;
    collision::MoverCache cache_;
    collision::MoverCache upright_cache_;  ///< of the body at its full height
    collision::MoverState state_;
    collision::MoveTrace trace_;
    bool obstructed_ = false;   ///< in the last tick it didn't get as far ahead as desired
    int obstructed_ticks_ = 0;  ///< of this stride
    SharedFall shared_;         ///< the beginning of the last stride
    std::vector<collision::Vec3> path_;
    std::vector<bool> touched_;
    std::vector<collision::ObjectId> below_;
    std::uint64_t ticks_ = 0;
};

}  // namespace campuswalk::engine
