#include "collision/mover/ground_query.h"

#include <algorithm>
#include <cmath>

#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// A point this near a walkable face belongs to it, metres: treads and risers are modelled with gaps.
constexpr double kSurfaceTolerance = 0.01;
/// How far onto a piece the body has to walk to be carried by it, metres.
constexpr double kStepOntoDistance = 0.01;
/// A contact this low beside the sphere's centre, as a share of its radius, doesn't support it: with a radius
/// 15 µm smaller, there would be none.
constexpr double kMinSupportDrop = 0.01;

using Piece = ContactCache::Piece;
using Rest = MoveBuffers::Rest;

/// None where it would rest below `useful`, too. What it rests on doesn't depend on that, to the last bit:
/// that depends on the order of the pieces, which is the cache's.
std::optional<SphereRest> rest_on(const Piece& piece, double x, double z, double reach, double highest,
                                  double lowest, double useful) {
    const Aabb& box = piece.box;
    // The sphere rests no higher than it would on the nearest point of the box's top.
    const double dx = std::max({box.min.x() - x, x - box.max.x(), 0.0});
    const double dz = std::max({box.min.z() - z, z - box.max.z(), 0.0});
    const double left = reach * reach - (dx * dx + dz * dz);
    const double above = useful - box.max.y();
    if (left < 0.0 || (above > 0.0 && above * above > left) || box.min.y() - reach > highest) {
        return std::nullopt;
    }
    const Obstacle& o = piece.obstacle;
    if (o.solid == nullptr) {
        return sphere_rest(o.vertices, o.normal, x, z, reach);
    }
    const Segment sphere{{x, highest, z}, {x, highest, z}};
    const Vec3 drop(0, lowest - highest, 0);
    if (closest(sphere, o).distance <= reach) {
        return std::nullopt;  // beside or above
    }
    const auto fraction = sweep(sphere, reach, drop, o);
    if (!fraction) {
        return std::nullopt;
    }
    const Vec3 center = sphere.a + *fraction * drop;
    return SphereRest{center.y(), closest(Segment{center, center}, o).on_shape};
}

bool ends_in_floor(const MoveContext& context, const Vec3& point) {
    return std::ranges::any_of(context.contacts.pieces(), [&](const Piece& p) {
        if ((point.array() < p.box.min.array() - kSurfaceTolerance).any() ||
            (point.array() > p.box.max.array() + kSurfaceTolerance).any()) {
            return false;
        }
        const Closest c = closest(Segment{point, point}, p.obstacle);
        return c.distance <= kSurfaceTolerance && walkable_at(p.obstacle, c.on_shape, context.body.min_up);
    });
}

bool carries(const MoveContext& context, const Rest& rest, double highest) {
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

double highest_edge(const MoverSettings& body, const Support& stand) {
    return stand.base + body.step_height + kHeightSlack;
}

/// Is the piece higher than `height` where the body would touch it? A face that slants down beside a stair
/// may be tall elsewhere.
bool rises_above(const MoverSettings& body, const Obstacle& obstacle, const Vec3& foot, double height) {
    if (obstacle.top <= height) {
        return false;
    }
    const double bottom = std::max(foot.y() + body.radius, height + kHeightSlack);
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
        (s.on_piece.y() > highest || rises_above(body, piece.obstacle, foot, highest))) {
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
        find_ground(context, foot.x() - ahead * s.normal.x(), foot.z() - ahead * s.normal.z(), stand,
                    highest - foot.y(), 2.0 * kRestGap);
    return there.found && !there.carries ? PieceKind::wall : PieceKind::step;
}

}  // namespace

Ground find_ground(MoveContext& context, double x, double z, const Support& stand, double up, double down) {
    const double radius = context.body.radius;
    const double reach = radius + kRestGap;
    std::vector<Rest>& rests = context.buffers.rests;
    const double center = stand.foot.y() + radius;
    const double highest = center + up;
    const double lowest = center - down;
    rests.clear();
    double best = lowest;
    for (const ContactCache::Index i : context.near) {
        const auto sphere = rest_on(context.contacts.piece(i), x, z, reach, highest, lowest - 2.0 * kRestGap,
                                    best - 2.0 * kRestGap);
        if (sphere && sphere->height <= highest && sphere->height >= best - 2.0 * kRestGap &&
            sphere->height - sphere->on.y() > kMinSupportDrop * radius) {
            rests.push_back({i, *sphere});
            best = std::max(best, sphere->height);
        }
    }
    Ground ground;
    ground.support_y = lowest - radius;
    for (const Rest& rest : rests) {
        if (rest.sphere.height >= best - 2.0 * kRestGap && rest.sphere.height >= lowest) {
            ground.found = true;
            if (carries(context, rest, highest_edge(context.body, stand))) {
                ground.carries = true;
                ground.support_y = std::max(ground.support_y, rest.sphere.on.y());
            }
        }
    }
    ground.foot_y = best - radius;
    return ground;
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
