#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/geometry/closest.h"
#include "collision/mover/mover_settings.h"
#include "collision/world/obstacle.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

/// What a piece near the body is to it.
enum class Kind : std::uint8_t {
    floor,  ///< underfoot
    step,   ///< low, and climbed if walked into
    wall,
};

/// How the body, standing somewhere, is apart from a piece. Both are convex and the body is only shifted, so
/// the plane between the closest points tells something about every other place too.
struct Separation {
    Vec3 foot = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  ///< where the body stands
    Vec3 normal = Vec3::Zero();  ///< unit, from the piece to the body; the face's own where they meet
    Vec3 on_piece = Vec3::Zero();
    double distance = 0.0;  ///< from the capsule's core
    Feature feature = Feature::face;
    /// What the piece is to a body that stands there, once `classify` (ground_query.h) has found out, and the
    /// height that edges counted from then.
    std::optional<Kind> kind;
    double kind_from = 0.0;

    /// A body at `other` is no nearer than this.
    double bound(const Vec3& other) const {
        return distance > 0.0 ? distance + normal.dot(other - foot) : 0.0;
    }
};

/// The pieces of the solid world around a body: triangles and round solids; boxes come apart into
/// triangles. When the body comes near the end of what was gathered, what lies beyond is gathered too, and
/// what is far behind dropped. What is kept from earlier ticks saves time and never changes an answer.
class ContactCache {
public:
    using Index = std::uint32_t;

    struct Piece {
        Obstacle obstacle;
        Aabb box;               ///< not smaller than the piece
        bool walkable = false;  ///< a triangle that isn't too steep, from either side
    };

    /// Whether it was prepared for just these.
    bool is_for(const World& world, const MoverSettings& settings, const QueryFilter& filter) const;
    /// Clears it, for a body with these settings among the objects that the filter lets through.
    void prepare(const World& world, const MoverSettings& settings, const QueryFilter& filter);
    /// Drops the contents and retains the memory.
    void clear();

    /// Sees to it that everything in `box` has been gathered.
    void cover(const Aabb& box, QueryStatistics* statistics = nullptr);

    /// Finds the pieces that the body may come within `reach` of on its way from `foot` to anywhere up to
    /// `sideways`, `up` and `down` from it. The answer is valid until the next call or `cover`.
    std::span<const Index> survey(const Vec3& foot, double sideways, double up, double down, double reach);
    std::span<const Piece> pieces() const { return pieces_; }
    const Piece& piece(Index i) const { return pieces_[i]; }

    /// Measures how the body at `foot` is apart from a piece, exactly, and keeps it: the last two places that
    /// a piece was measured from aren't measured again.
    Separation& measure(Index i, const Vec3& foot);
    /// Whether what has been measured shows that the body stays `distance` off the piece all the way.
    bool known_apart(Index i, const Vec3& from, const Vec3& to, double distance) const;

private:
    struct Gathering;
    static constexpr std::size_t kLanes = 8;
    static constexpr double kFirstMargin = 0.5;
    using Lanes = std::array<float, kLanes>;

    /// Of eight pieces lower bounds of the distance, linear in where the body stands: `rest` with its foot at
    /// the origin, and `x y z` for each metre from there; `flat` is the length of (x, z).
    struct Bounds {
        Lanes x{}, y{}, z{}, flat{}, rest{};
    };
    struct CachedPiece {
        std::array<Separation, 2> places;
        std::uint8_t last = 0;
    };

    void go_on_to(const Aabb& box, QueryStatistics* statistics);
    void drop_outside();
    void gather(const Aabb& before, QueryStatistics* statistics);
    void gather_round(ObjectId id);
    void gather_box(ObjectId id, const Box& box);
    void name_pieces();
    bool holds(ObjectId id, std::uint32_t triangle) const;
    void add(const Obstacle& obstacle, const Aabb& box);
    void add_triangle(ObjectId id, std::uint32_t index, const Triangle& vertices);
    void restart_bounds();
    void reserve_for(std::size_t count);
    void bound_by_box(Index i);
    void set_bound(Index i, const Vec3& normal, double at_origin);

    const World* world_ = nullptr;
    MoverSettings settings_;
    QueryFilter filter_;

    Aabb covered_;
    double margin_ = kFirstMargin;  ///< of what is gathered next, metres
    Vec3 origin_ = Vec3::Zero();    ///< of the bounds
    double slack_ = 0.0;            ///< what float32 may be off within what is covered
    std::vector<Piece> pieces_;
    /// The pieces by object and triangle, hashed: a refill asks for nearly all of them whether they are
    /// there.
    std::vector<std::uint64_t> names_;
    std::vector<CachedPiece> cached_;
    std::vector<Bounds> bounds_;
    std::vector<Index> near_;  ///< room for what `survey` finds
    std::vector<ObjectId> candidates_;
};

}  // namespace campuswalk::collision
