#include "collision/mover/wall_slide.h"

#include <algorithm>

#include "collision/mover/motion_clearance.h"

namespace campuswalk::collision {

namespace {

/// The half-plane of a piece that the body stays `gap` away from.
HalfPlane wall_of(const Separation& s, double radius, double gap) {
    const double flat = horizontal_norm(s.normal);
    const double room = std::max(0.0, s.distance - radius - gap);
    return {s.normal.x() / flat, s.normal.z() / flat, room / flat};
}

/// How steeply, as the downward part of its normal, something must hang over a body that may get by under it
/// on its way down a slope: no slope that is walked on is steeper than its complement.
constexpr double kOverhang = 0.5;

/// Fills the buffers with the flat walls and the edges that a move of `length` may run into. Returns whether
/// some hang over the body.
bool find_walls(MoveContext& context, const Support& stand, double length, bool grounded,
                Overhangs overhangs) {
    constexpr double kVertical = 1e-6;
    bool overhung = false;
    const MoverSettings& body = context.body;
    const Vec3& foot = stand.foot;
    context.buffers.walls.clear();
    context.buffers.edges.clear();
    const double reach = body.radius + body.skin + length + kRestGap;
    const double surely_floor = foot.y() + body.step_height;
    for (const ContactCache::Index i : context.near) {
        const ContactCache::Piece& piece = context.contacts.piece(i);
        if ((grounded && piece.walkable && piece.obstacle.top <= surely_floor) ||
            context.contacts.known_apart(i, foot, foot, reach)) {
            continue;
        }
        const Separation& s = context.contacts.measure(i, foot);
        if (s.distance > reach || horizontal_norm(s.normal) <= kVertical) {
            continue;
        }
        const bool wall =
            grounded ? classify(context, i, stand) == PieceKind::wall : s.normal.y() < body.min_up;
        if (!wall || (overhangs == Overhangs::pass && s.normal.y() <= -kOverhang)) {
            continue;
        }
        overhung = overhung || s.normal.y() <= -kOverhang;
        if (s.feature == Feature::face) {
            context.buffers.walls.push_back(wall_of(s, body.radius, body.skin));
        } else {
            context.buffers.edges.push_back(i);
        }
    }
    return overhung;
}

}  // namespace

Slide slide(MoveContext& context, const Support& stand, const Vec3& desired, bool grounded,
            Overhangs overhangs) {
    const Vec3& foot = stand.foot;
    std::vector<HalfPlane>& walls = context.buffers.walls;
    std::vector<ContactCache::Index>& edges = context.buffers.edges;
    const bool overhung = find_walls(context, stand, horizontal_norm(desired), grounded, overhangs);
    while (true) {
        const Vec3 move = nearest_allowed(desired, walls);
        const auto hit = std::partition(edges.begin(), edges.end(), [&](ContactCache::Index i) {
            return !comes_near(context, i, foot, move);
        });
        if (hit == edges.end()) {
            return {move, walls, overhung};
        }
        for (auto i = hit; i != edges.end(); ++i) {
            walls.push_back(wall_of(context.contacts.measure(*i, foot), context.body.radius, kRestGap));
        }
        edges.erase(hit, edges.end());
    }
}

}  // namespace campuswalk::collision
