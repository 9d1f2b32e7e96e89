#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
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

/// What a piece near the body means to its motion.
enum class PieceKind : std::uint8_t {
    floor,  ///< underfoot
    step,   ///< low: the body climbs it when it walks into it
    wall,
};

/// The separation of the body at one place from a piece. Both are convex and the body only translates, so the
/// plane between the closest points also bounds the distance at every other place.
struct Separation {
    Vec3 foot = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  ///< of the body
    Vec3 normal = Vec3::Zero();  ///< unit, from the piece to the body; the face's own where they overlap
    Vec3 on_piece = Vec3::Zero();
    double distance = 0.0;  ///< from the capsule's core
    Feature feature = Feature::face;
    /// What the piece is to a body that stands there, once `classify` (ground_query.h) has been called, and
    /// the height that it measured edges from.
    std::optional<PieceKind> kind;
    double kind_base = 0.0;

    /// A lower bound of the distance of a body at `other`.
    double bound(const Vec3& other) const {
        return distance > 0.0 ? distance + normal.dot(other - foot) : 0.0;
    }
};

/// The pieces of the solid world around a body: triangles and round solids; a box is split into triangles.
/// When the body comes to the edge of the covered region, the cache gathers what lies beyond it and drops
/// what is far behind. What it retains from earlier ticks saves time and never changes a result.
class ContactCache {
public:
    using Index = std::uint32_t;

    struct Piece {
        Obstacle obstacle;
        Aabb box;               ///< contains the piece
        bool walkable = false;  ///< a triangle that isn't too steep, on either side
    };

    /// Whether it was prepared for exactly these.
    bool is_for(const World& world, const MoverSettings& settings, const QueryFilter& filter) const;
    /// Clears the cache and sets the body and the objects that it is for.
    void prepare(const World& world, const MoverSettings& settings, const QueryFilter& filter);
    /// Drops the contents and retains the memory.
    void clear();

    /// Gathers the pieces in `box` that aren't cached yet; if it has to, those so far below as well, metres.
    void cover(const Aabb& box, double below = 0.0, QueryStatistics* statistics = nullptr);

    /// The pieces that the body may come within `reach` of as it moves from `foot` to anywhere up to
    /// `sideways`, `up` and `down` from there. The result is valid until the next `survey` or `cover`.
    std::span<const Index> survey(const Vec3& foot, double sideways, double up, double down, double reach);
    /// Pieces that there is memory for.
    std::size_t capacity() const { return pieces_.capacity(); }
    /// Where all pieces are known.
    const Aabb& covered() const { return covered_; }
    std::span<const Piece> pieces() const { return pieces_; }
    const Piece& piece(Index i) const { return pieces_[i]; }

    /// The exact separation of the body at `foot` from a piece. The last two measurements of each piece are
    /// cached.
    Separation& measure(Index i, const Vec3& foot);
    /// A lower bound of the body's distance from the piece, by its box or the cached measurements.
    double known_distance(Index i, const Vec3& foot) const;
    /// Whether its box or the cached measurements prove that the body stays at least `distance` from the
    /// piece during the straight motion.
    bool known_apart(Index i, const Vec3& from, const Vec3& to, double distance) const;

private:
    struct PieceGatherer;
    static constexpr std::size_t kLanes = 8;
    static constexpr double kFirstMargin = 0.5;
    using Lanes = std::array<float, kLanes>;

    /// Lower bounds of the distances of eight pieces, linear in the foot's position: `offset` with the foot
    /// at `origin_`, and `x y z` per metre from there; `flat` is the length of (x, z).
    struct Bounds {
        Lanes x{}, y{}, z{}, flat{}, offset{};
    };
    struct Measurements {
        std::array<Separation, 2> measured;
        std::uint8_t last = 0;  ///< index of the latest
    };
    static constexpr std::uint32_t kNotMeasured = std::numeric_limits<std::uint32_t>::max();

    void move_to(const Aabb& box, QueryStatistics* statistics);
    void drop_outside();
    void gather(const Aabb& before, QueryStatistics* statistics);
    void gather_round(ObjectId id);
    void gather_box(ObjectId id, const Box& box);
    void rebuild_keys();
    bool has_piece(ObjectId id, std::uint32_t triangle) const;
    void add(const Obstacle& obstacle, const Aabb& box);
    void add_triangle(ObjectId id, std::uint32_t index, const Triangle& vertices);
    void add_measurements();
    Measurements& measurements_of(Index i);
    void restart_bounds();
    void reserve_for(std::size_t count);
    void bound_by_box(Index i);
    void set_bound(Index i, const Vec3& normal, double at_origin);
    double bound(Index i, const Vec3& foot) const;

    const World* world_ = nullptr;
    MoverSettings settings_;
    QueryFilter filter_;

    Aabb covered_;
    double margin_ = kFirstMargin;  ///< around what is gathered next, metres
    Vec3 origin_ = Vec3::Zero();    ///< of `bounds_`
    double slack_ = 0.0;            ///< the error of float32 within the covered region
    std::vector<Piece> pieces_;
    /// A hash set of the pieces, by object and triangle: a refill looks up nearly all of them.
    std::vector<std::uint64_t> keys_;
    std::vector<std::uint32_t> measured_;    ///< by piece: index into `measurements_`, or kNotMeasured
    std::deque<Measurements> measurements_;  ///< most pieces are never measured
    std::vector<std::uint32_t> unused_;      ///< indices into `measurements_`
    std::vector<Bounds> bounds_;
    std::vector<Index> near_;  ///< what `survey` returns
    std::vector<ObjectId> candidates_;
};

}  // namespace campuswalk::collision
