#include "collision/mover/ground_query.h"

#include <algorithm>
#include <cmath>

#include "collision/mover/ground_candidates.h"
#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// A point this near a walkable face belongs to it, metres: treads and risers are modelled with gaps.
constexpr double kSurfaceTolerance = 0.01;
/// How far onto a piece the body has to walk to be carried by it, metres.
constexpr double kStepOntoDistance = 0.01;

/// From so many pieces on, those that may carry the body are picked once and not for each piece anew.
constexpr std::size_t kManyNear = 32;

using Piece = ContactCache::Piece;
using Rest = MoveBuffers::Rest;

/// Whether the point is farther than the tolerance from the triangle's plane, and the triangle surely in it.
bool is_off_plane(const Obstacle& triangle, const Vec3& point) {
    constexpr double kFlat = 1e-6;  // metres
    const Triangle& t = triangle.vertices;
    const Vec3& n = triangle.normal;
    return std::abs(n.dot(point - t.a)) > kSurfaceTolerance + 2.0 * kFlat &&
           std::abs(n.dot(t.b - t.a)) < kFlat && std::abs(n.dot(t.c - t.a)) < kFlat;
}

bool is_within_tolerance(const Obstacle& triangle, const Vec3& point) {
    if (is_off_plane(triangle, point)) {
        return false;
    }
    Feature feature = Feature::face;
    const Vec3 nearest = closest_on_triangle(triangle.vertices, point, feature);
    return (point - nearest).norm() <= kSurfaceTolerance ||
           closest(Segment{point, point}, triangle.vertices).distance <= kSurfaceTolerance;
}

bool is_on_floor(const MoveContext& context, const Vec3& point) {
    return std::ranges::any_of(context.contacts.pieces(), [&](const Piece& p) {
        const bool is_triangle = p.obstacle.solid == nullptr;
        if (is_triangle && !p.walkable) {
            return false;
        }
        if ((point.array() < p.box.min.array() - kSurfaceTolerance).any() ||
            (point.array() > p.box.max.array() + kSurfaceTolerance).any()) {
            return false;
        }
        if (is_triangle) {
            return is_within_tolerance(p.obstacle, point);
        }
        const Closest c = closest(Segment{point, point}, p.obstacle);
        return c.distance <= kSurfaceTolerance && walkable_at(p.obstacle, c.on_shape, context.body.min_up);
    });
}

/// What carries a body beside one piece often carries it beside the next.
bool ends_in_floor(MoveContext& context, const Vec3& point) {
    auto& known = context.buffers.floor_end;
    if (!known || known->point != point) {
        known = {point, is_on_floor(context, point)};
    }
    return known->is_there;
}

double highest_edge(const MoverSettings& body, const Support& stand) {
    return stand.base + body.step_height + kHeightSlack;
}

bool carries(MoveContext& context, const Rest& rest, double highest) {
    const Obstacle& o = context.contacts.piece(rest.piece).obstacle;
    const Vec3& on = rest.sphere.on;
    const double up = (rest.sphere.height - on.y()) / (context.body.radius + kRestGap);
    const bool low = on.y() <= highest;
    if (walkable_at(o, on, context.body.min_up)) {
        // The crest of a ramp is higher than its foot, and reached on a face as steep as the touch.
        constexpr double kSlopeTolerance = 1e-6;
        return low || (o.solid == nullptr && std::abs(o.normal.y()) <= up + kSlopeTolerance);
    }
    return low && (up >= context.body.min_up || ends_in_floor(context, on));
}

/// Finds the highest of the pieces that a sphere comes to rest on which moves straight down at (x, z).
class GroundSearch {
public:
    GroundSearch(MoveContext& context, double x, double z, const Support& stand, double up, double down,
                 double min_drop)
        : context_(context),
          stand_(stand),
          x_(x),
          z_(z),
          reach_(context.body.radius + kRestGap),
          highest_(stand.foot.y() + context.body.radius + up),
          lowest_(stand.foot.y() + context.body.radius - down),
          min_drop_(min_drop * context.body.radius),
          best_(lowest_) {
        context.buffers.rests.clear();
    }

    /// A rest below this doesn't count any more.
    double useful() const { return best_ - 2.0 * kRestGap; }
    double highest() const { return highest_; }
    std::optional<ContactCache::Index> highest_piece() const { return highest_piece_; }

    void offer(ContactCache::Index i) {
        const Piece& piece = context_.contacts.piece(i);
        if (may_carry(piece.box)) {
            offer_near(i, piece.obstacle);
        }
    }

    Ground found() const {
        const double radius = context_.body.radius;
        const double highest_on = highest_edge(context_.body, stand_);
        Ground ground;
        ground.support_y = lowest_ - radius;
        for (const Rest& rest : context_.buffers.rests) {
            if (rest.sphere.height < useful() || rest.sphere.height < lowest_) {
                continue;
            }
            ground.found = true;
            const bool adds_nothing = ground.carries && rest.sphere.on.y() <= ground.support_y;
            if (!adds_nothing && carries(context_, rest, highest_on)) {
                ground.carries = true;
                ground.support_y = std::max(ground.support_y, rest.sphere.on.y());
            }
        }
        ground.foot_y = best_ - radius;
        return ground;
    }

private:
    /// Whether the sphere may rest on what is in the box, at a height that counts: it rests no higher than it
    /// would on the nearest point of the box's top, and above what is too high it isn't looked for.
    bool may_carry(const Aabb& box) const {
        const double dx = std::max({box.min.x() - x_, x_ - box.max.x(), 0.0});
        const double dz = std::max({box.min.z() - z_, z_ - box.max.z(), 0.0});
        const double left = reach_ * reach_ - (dx * dx + dz * dz);
        const double above = useful() - box.max.y();
        return left >= 0.0 && (above <= 0.0 || above * above <= left) && box.min.y() - reach_ <= highest_;
    }

    /// None where it would rest below what is useful, too. What it rests on doesn't depend on that, to the
    /// last bit: that depends on the order of the pieces, which is the cache's.
    std::optional<SphereRest> rest_on(const Obstacle& o) const {
        if (o.solid == nullptr) {
            return sphere_rest(o.vertices, o.normal, x_, z_, reach_, useful());
        }
        const Segment sphere{{x_, highest_, z_}, {x_, highest_, z_}};
        const Vec3 drop(0, lowest_ - 2.0 * kRestGap - highest_, 0);
        if (closest(sphere, o).distance <= reach_) {
            return std::nullopt;  // beside or above
        }
        const auto fraction = sweep(sphere, reach_, drop, o);
        if (!fraction) {
            return std::nullopt;
        }
        const Vec3 center = sphere.a + *fraction * drop;
        return SphereRest{center.y(), closest(Segment{center, center}, o).on_shape};
    }

    /// Not inline: over half of the pieces don't get here, and are left the sooner.
    [[gnu::noinline]] void offer_near(ContactCache::Index i, const Obstacle& obstacle) {
        const auto sphere = rest_on(obstacle);
        if (sphere && sphere->height <= highest_ && sphere->height >= useful() &&
            sphere->height - sphere->on.y() > min_drop_) {
            context_.buffers.rests.push_back({i, *sphere});
            if (sphere->height >= best_) {
                best_ = sphere->height;
                highest_piece_ = i;
            }
        }
    }

    MoveContext& context_;
    const Support& stand_;
    double x_;
    double z_;
    double reach_;
    double highest_;  ///< that its centre may be
    double lowest_;
    double min_drop_;
    double best_;
    std::optional<ContactCache::Index> highest_piece_;
};

/// Is the piece higher than `height` where the body would touch it? A face that slants down beside a stair
/// may be tall elsewhere. One that leans back is touched lower than where the body comes nearest to it.
bool rises_above(const MoverSettings& body, const Obstacle& obstacle, const Separation& s, const Vec3& foot,
                 double height) {
    if (obstacle.top <= height) {
        return false;
    }
    // From here up, the plane that it touches would be nearest above `height`.
    const double lean = std::max(0.0, s.normal.y());
    const double center = foot.y() + body.radius;
    const double above = (height + kHeightSlack + lean * (s.distance - lean * center)) / (1.0 - lean * lean);
    const double bottom = std::max(center, above);
    const double top = std::max(bottom, foot.y() + body.height - body.radius);
    const Segment upper{{foot.x(), bottom, foot.z()}, {foot.x(), top, foot.z()}};
    return closest_upright(upper, obstacle).on_shape.y() > height;
}

PieceKind kind_of(MoveContext& context, const Piece& piece, const Separation& s, const Support& stand) {
    const MoverSettings& body = context.body;
    const Vec3& foot = stand.foot;
    const bool walkable_touch = s.normal.y() >= body.min_up;
    if (walkable_touch && s.feature == Feature::face) {
        return PieceKind::floor;
    }
    // The edge of a floor may be the crest of a ramp, however high.
    const bool may_be_crest = piece.walkable && s.normal.y() > 0.0;
    const double highest = highest_edge(body, stand);
    if (!walkable_touch && !may_be_crest &&
        (s.on_piece.y() > highest || rises_above(body, piece.obstacle, s, foot, highest))) {
        return PieceKind::wall;
    }
    const double flat = horizontal_norm(s.normal);
    if (flat <= 0.0) {
        return walkable_touch ? PieceKind::floor : PieceKind::wall;
    }
    // What would carry the body there? If nothing would, it may walk over the edge and fall.
    const double gap = std::max(0.0, s.distance - body.radius);
    const double ahead = std::min(gap / flat + kStepOntoDistance, kProbeDistance) / flat;
    const Ground there =
        find_ground_beside(context, foot.x() - ahead * s.normal.x(), foot.z() - ahead * s.normal.z(), stand);
    return there.found && !there.carries ? PieceKind::wall : PieceKind::step;
}

}  // namespace

Ground find_ground(MoveContext& context, double x, double z, const Support& stand, double up, double down,
                   double min_drop) {
    GroundSearch search(context, x, z, stand, up, down, min_drop);
    std::optional<ContactCache::Index>& highest = context.buffers.ground.highest;
    if (highest) {
        search.offer(*highest);  // then most of the others need no second look
    }
    for (const ContactCache::Index i : context.near) {
        if (i != highest) {
            search.offer(i);
        }
    }
    highest = search.highest_piece();
    return search.found();
}

Ground find_ground_beside(MoveContext& context, double x, double z, const Support& stand) {
    const double up = highest_edge(context.body, stand) - stand.foot.y();
    const double down = 2.0 * kRestGap;
    if (context.near.size() < kManyNear) {
        return find_ground(context, x, z, stand, up, down);
    }
    GroundCandidates& ground = context.buffers.ground;
    if (ground.foot != stand.foot || ground.base != stand.base) {
        list_candidates(context, stand, up, down);
    }
    GroundSearch search(context, x, z, stand, up, down, kMinSupportDrop);
    if (ground.highest) {
        search.offer(*ground.highest);
    }
    const auto chosen = choose_candidates(ground, context.body.radius + kRestGap,
                                          {.x = static_cast<float>(x - stand.foot.x()),
                                           .z = static_cast<float>(z - stand.foot.z()),
                                           .useful = static_cast<float>(search.useful() - stand.foot.y()),
                                           .highest = static_cast<float>(search.highest() - stand.foot.y())});
    for (const std::uint32_t i : chosen) {
        if (i < ground.pieces.size() && ground.pieces[i] != ground.highest) {
            search.offer(ground.pieces[i]);
        }
    }
    ground.highest = search.highest_piece();
    return search.found();
}

PieceKind classify(MoveContext& context, ContactCache::Index i, const Support& stand) {
    const Piece& piece = context.contacts.piece(i);
    const double top = piece.obstacle.top;
    if (top <= stand.foot.y() || (piece.walkable && top <= highest_edge(context.body, stand))) {
        return PieceKind::floor;
    }
    Separation& s = context.contacts.measure(i, stand.foot);
    if (!s.kind || s.kind_base != stand.base) {
        s.kind = kind_of(context, piece, s, stand);
        s.kind_base = stand.base;
    }
    return *s.kind;
}

}  // namespace campuswalk::collision
