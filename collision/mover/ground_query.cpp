#include "collision/mover/ground_query.h"

#include <algorithm>
#include <cmath>

#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// A point this near a walkable face belongs to it: treads and risers are modelled with gaps, metres.
constexpr double kOwned = 0.01;
/// How far into a piece the body has to walk to be on it, metres.
constexpr double kOnto = 0.01;
/// What touches the ball's side this flatly, as a share of its radius, doesn't hold it: 15 µm less of it and
/// it wouldn't be met.
constexpr double kSide = 0.01;

using Piece = ContactCache::Piece;
using Rest = MoveBuffers::Rest;

std::optional<SphereRest> rest_on(const Piece& piece, double x, double z, double reach, double highest,
                                  double lowest) {
    const Aabb& box = piece.box;
    // The ball rests no higher than it would on the nearest point of the box's top.
    const double dx = std::max({box.min.x() - x, x - box.max.x(), 0.0});
    const double dz = std::max({box.min.z() - z, z - box.max.z(), 0.0});
    const double left = reach * reach - (dx * dx + dz * dz);
    const double above = lowest - box.max.y();
    if (left < 0.0 || (above > 0.0 && above * above > left) || box.min.y() - reach > highest) {
        return std::nullopt;
    }
    const Obstacle& o = piece.obstacle;
    if (o.solid == nullptr) {
        return sphere_rest(o.vertices, o.normal, x, z, reach);
    }
    const Segment ball{{x, highest, z}, {x, highest, z}};
    const Vec3 drop(0, lowest - highest, 0);
    if (closest(ball, o).distance <= reach) {
        return std::nullopt;  // beside or above
    }
    const auto fraction = sweep(ball, reach, drop, o);
    if (!fraction) {
        return std::nullopt;
    }
    const Vec3 center = ball.a + *fraction * drop;
    return SphereRest{center.y(), closest(Segment{center, center}, o).on_shape};
}

bool ends_in_floor(const MoveContext& context, const Vec3& point) {
    return std::ranges::any_of(context.contacts.pieces(), [&](const Piece& p) {
        if ((point.array() < p.box.min.array() - kOwned).any() ||
            (point.array() > p.box.max.array() + kOwned).any()) {
            return false;
        }
        const Closest c = closest(Segment{point, point}, p.obstacle);
        return c.distance <= kOwned && walkable_at(p.obstacle, c.on_shape, context.body.min_up);
    });
}

bool carries(const MoveContext& context, const Rest& rest, double highest) {
    const Obstacle& o = context.contacts.piece(rest.piece).obstacle;
    const Vec3& on = rest.ball.on;
    const double up = (rest.ball.height - on.y()) / (context.body.radius + kRest);
    const bool low = on.y() <= highest;
    if (walkable_at(o, on, context.body.min_up)) {
        // The crest of a ramp is higher than its foot, and walked up to on a face as steep as the touch.
        constexpr double kAlike = 1e-6;
        return low || (o.solid == nullptr && std::abs(o.normal.y()) <= up + kAlike);
    }
    return low && (up >= context.body.min_up || ends_in_floor(context, on));
}

double highest_edge(const MoverSettings& body, const Support& stand) {
    return stand.base + body.step_height + kHeightSlack;
}

/// Is the piece higher than `height` where the body would meet it? A face that slants down beside a stair
/// may be tall elsewhere.
bool reaches_over(const MoverSettings& body, const Obstacle& obstacle, const Vec3& foot, double height) {
    if (obstacle.top <= height) {
        return false;
    }
    const double bottom = std::max(foot.y() + body.radius, height + kHeightSlack);
    const double top = std::max(bottom, foot.y() + body.height - body.radius);
    const Segment upper{{foot.x(), bottom, foot.z()}, {foot.x(), top, foot.z()}};
    return closest_upright(upper, obstacle).on_shape.y() > height;
}

Kind kind_of(MoveContext& context, const Piece& piece, const Separation& s, const Support& stand) {
    const MoverSettings& body = context.body;
    const Vec3& foot = stand.foot;
    const bool below = s.normal.y() >= body.min_up;
    if (below && s.feature == Feature::face) {
        return Kind::floor;
    }
    // The edge of a floor may be the crest of a ramp, however high.
    const bool may_be_crest = piece.walkable && s.normal.y() > 0.0;
    const double highest = highest_edge(body, stand);
    if (!below && !may_be_crest &&
        (s.on_piece.y() > highest || reaches_over(body, piece.obstacle, foot, highest))) {
        return Kind::wall;
    }
    const double flat = horizontal_norm(s.normal);
    if (flat <= 0.0) {
        return below ? Kind::floor : Kind::wall;
    }
    // What would carry the body if it went there?
    const double gap = std::max(0.0, s.distance - body.radius);
    const double ahead = std::min(gap / flat + kOnto, kProbe) / flat;
    const Ground there = find_ground(context, foot.x() - ahead * s.normal.x(),
                                     foot.z() - ahead * s.normal.z(), stand, highest - foot.y(), 2.0 * kRest);
    return there.found && !there.carries ? Kind::wall : Kind::step;
}

}  // namespace

Ground find_ground(MoveContext& context, double x, double z, const Support& stand, double up, double down) {
    const double radius = context.body.radius;
    const double reach = radius + kRest;
    std::vector<Rest>& rests = context.buffers.rests;
    const double center = stand.foot.y() + radius;
    const double highest = center + up;
    const double lowest = center - down;
    rests.clear();
    double best = lowest;
    for (const ContactCache::Index i : context.near) {
        const auto ball = rest_on(context.contacts.piece(i), x, z, reach, highest, best - 2.0 * kRest);
        if (ball && ball->height <= highest && ball->height >= best - 2.0 * kRest &&
            ball->height - ball->on.y() > kSide * radius) {
            rests.push_back({i, *ball});
            best = std::max(best, ball->height);
        }
    }
    Ground ground;
    ground.at = lowest - radius;
    for (const Rest& rest : rests) {
        if (rest.ball.height >= best - 2.0 * kRest && rest.ball.height >= lowest) {
            ground.found = true;
            if (carries(context, rest, highest_edge(context.body, stand))) {
                ground.carries = true;
                ground.at = std::max(ground.at, rest.ball.on.y());
            }
        }
    }
    ground.foot_y = best - radius;
    return ground;
}

Kind classify(MoveContext& context, ContactCache::Index i, const Support& stand) {
    const Piece& piece = context.contacts.piece(i);
    const double top = piece.obstacle.top;
    if (top <= stand.foot.y() || (piece.walkable && top <= highest_edge(context.body, stand))) {
        return Kind::floor;
    }
    Separation& s = context.contacts.measure(i, stand.foot);
    if (!s.kind || s.kind_from != stand.base) {
        s.kind = kind_of(context, piece, s, stand);
        s.kind_from = stand.base;
    }
    return *s.kind;
}

}  // namespace campuswalk::collision
