#include "collision/mover.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::collision {

namespace {

/// The gap the body rests at above the ground and beside edges: large against rounding, too small to see.
constexpr double kRest = 1e-4;
/// What every swept motion keeps; half of kRest, so that ground it rests on never counts as in the way.
constexpr double kHard = 0.5 * kRest;
/// A point this near a walkable surface belongs to it: treads and risers are modelled with gaps.
constexpr double kOwned = 0.01;
/// Slack on heights compared with the step height, for risers of exactly that height.
constexpr double kHeightSlack = 1e-3;
/// How far beyond contact touching objects are still listed, for the hysteresis of events.
constexpr double kListed = 0.05;
constexpr double kStill = 1e-9;

double horizontal_norm(const Vec3& v) {
    return std::sqrt(v.x() * v.x() + v.z() * v.z());
}

}  // namespace

CapsuleMover::CapsuleMover(const World& world, const MoverSettings& settings, const QueryFilter& filter)
    : world_(world), settings_(settings), filter_(filter) {}

Segment CapsuleMover::body(const Vec3& foot) const {
    return {foot + Vec3(0, settings_.radius, 0), foot + Vec3(0, settings_.height - settings_.radius, 0)};
}

void CapsuleMover::gather(const Vec3& foot, double sideways, double up, double down,
                          QueryCounters& counters) {
    const Segment reach{foot - Vec3(0, down, 0), foot + Vec3(0, settings_.height + up, 0)};
    const double radius = settings_.radius + settings_.skin + kListed + sideways;
    gather_obstacles(world_, filter_, reach, radius, obstacles_, counters);
}

bool CapsuleMover::owned_by_floor(const Vec3& point) const {
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& o) {
        const Closest c = closest(Segment{point, point}, o);
        return c.distance <= kOwned && walkable_at(o, c.on_shape, settings_.min_up);
    });
}

/// Something low whose top can be stood on, like the riser of a stair or the bevel of a kerb.
bool CapsuleMover::is_step(const Obstacle& obstacle, const Vec3& foot) const {
    const double highest = foot.y() + settings_.step_height + kHeightSlack;
    const double bottom = foot.y() + std::max(settings_.radius, settings_.step_height + 2 * kHeightSlack);
    const double top = std::max(bottom, foot.y() + settings_.height - settings_.radius);
    const Vec3 q =
        closest(Segment{{foot.x(), bottom, foot.z()}, {foot.x(), top, foot.z()}}, obstacle).on_shape;
    if (q.y() > highest) {
        return false;
    }
    if (owned_by_floor(q)) {
        return true;
    }
    if (obstacle.solid != nullptr || obstacle.top > highest) {
        return false;
    }
    const Triangle& t = obstacle.corners;
    const Vec3& ab = t.a.y() >= t.b.y() ? t.a : t.b;
    return owned_by_floor(ab.y() >= t.c.y() ? ab : t.c);
}

CapsuleMover::Kind CapsuleMover::kind_of(const Obstacle& obstacle, const Vec3& normal,
                                         const Vec3& foot) const {
    if (normal.y() >= settings_.min_up) {
        return Kind::floor;
    }
    return is_step(obstacle, foot) ? Kind::step : Kind::wall;
}

void CapsuleMover::find_contacts(const Vec3& foot, double reach) {
    contacts_.clear();
    const Segment at = body(foot);
    for (const Obstacle& o : obstacles_) {
        const Closest c = closest(at, o);
        if (c.distance - settings_.radius > reach) {
            continue;
        }
        Contact contact{&o, c, Vec3::Zero(), Kind::wall};
        contact.normal = c.distance > 0.0 ? Vec3((c.on_segment - c.on_shape) / c.distance) : o.normal;
        contact.kind = kind_of(o, contact.normal, foot);
        contacts_.push_back(contact);
    }
}

CapsuleMover::HalfPlane CapsuleMover::half_plane(const Contact& contact, double radius, double keep) {
    const double flat = horizontal_norm(contact.normal);
    const double room = std::max(0.0, contact.closest.distance - radius - keep);
    return {contact.normal.x() / flat, contact.normal.z() / flat, room / flat};
}

/// The point nearest to `wish` that satisfies every half-plane: `wish` itself, or on one line, or where two
/// meet. Standing still always satisfies all.
Vec3 CapsuleMover::solve(const Vec3& wish, const std::vector<HalfPlane>& planes) {
    const auto allowed = [&](double x, double z) {
        return std::all_of(planes.begin(), planes.end(),
                           [&](const HalfPlane& p) { return p.nx * x + p.nz * z >= -p.room - 1e-12; });
    };
    if (allowed(wish.x(), wish.z())) {
        return wish;
    }
    Vec3 best = Vec3::Zero();
    double best_distance = wish.squaredNorm();
    const auto offer = [&](double x, double z) {
        const double distance = (wish - Vec3(x, 0, z)).squaredNorm();
        if (distance < best_distance && allowed(x, z)) {
            best = Vec3(x, 0, z);
            best_distance = distance;
        }
    };
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const HalfPlane& p = planes[i];
        const double short_of = -p.room - (p.nx * wish.x() + p.nz * wish.z());
        offer(wish.x() + short_of * p.nx, wish.z() + short_of * p.nz);
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const HalfPlane& q = planes[j];
            const double determinant = p.nx * q.nz - p.nz * q.nx;
            if (std::abs(determinant) > 1e-9) {
                offer((-p.room * q.nz + q.room * p.nz) / determinant,
                      (-q.room * p.nx + p.room * q.nx) / determinant);
            }
        }
    }
    return best;
}

/// Holds the wish against the walls. Flat walls always count; an edge counts only once the move would run
/// into it, because an edge between two flush faces isn't there for the avatar.
Vec3 CapsuleMover::slide(const Vec3& foot, const Vec3& wish) {
    constexpr double kVertical = 1e-6;
    planes_.clear();
    in_solve_.assign(contacts_.size(), false);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& c = contacts_[i];
        const bool counts = c.kind == Kind::wall && horizontal_norm(c.normal) > kVertical;
        in_solve_[i] = !counts;
        if (counts && c.closest.feature == Feature::face) {
            planes_.push_back(half_plane(c, settings_.radius, settings_.skin));
            in_solve_[i] = true;
        }
    }
    const Segment at = body(foot);
    while (true) {
        Vec3 move = solve(wish, planes_);
        bool free = true;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            if (!in_solve_[i] && sweep(at, settings_.radius + kRest, move, *contacts_[i].obstacle)) {
                planes_.push_back(half_plane(contacts_[i], settings_.radius, kRest));
                in_solve_[i] = true;
                free = false;
            }
        }
        if (free) {
            return move;
        }
    }
}

/// How far the body must rise so that nothing it can climb is in the way: the height at which its lower
/// sphere, dropped from the step height, comes to rest along the move.
double CapsuleMover::needed_lift(const Vec3& foot, const Vec3& move) const {
    constexpr int kSamples = 4;
    const double length = move.norm();
    double lift = 0.0;
    for (const Contact& c : contacts_) {
        if (c.kind == Kind::wall || c.obstacle->top <= foot.y() - kRest) {
            continue;
        }
        for (int i = 1; i <= kSamples; ++i) {
            const Vec3 start = foot + (i / static_cast<double>(kSamples)) * move +
                               Vec3(0, settings_.step_height + settings_.radius + kHeightSlack, 0);
            const double drop = settings_.step_height + kHeightSlack;
            const Segment ball{start, start};
            if (closest(ball, *c.obstacle).distance <= settings_.radius) {
                continue;  // taller than a step from here: the forward sweep decides
            }
            if (const auto f = sweep(ball, settings_.radius + kRest, Vec3(0, -drop, 0), *c.obstacle)) {
                lift = std::max(lift, (1.0 - *f) * drop);
            }
        }
    }
    // Between two samples a round body rises by no more than the sagitta of the piece.
    const double piece = length / kSamples;
    return lift > 0.0 ? lift + piece * piece / (8.0 * settings_.radius) : 0.0;
}

Vec3 CapsuleMover::free_part(const Vec3& foot, const Vec3& move, double radius) const {
    const Segment at = body(foot);
    double fraction = 1.0;
    for (const Obstacle& o : obstacles_) {
        if (const auto f = sweep(at, radius, fraction * move, o)) {
            fraction *= *f;
        }
    }
    return fraction * move;
}

bool CapsuleMover::supported(const Vec3& foot) const {
    const Segment at = body(foot);
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& o) {
        const Closest c = closest(at, o);
        if (c.distance > settings_.radius + 2.0 * kRest || c.on_shape.y() > foot.y() + settings_.radius) {
            return false;
        }
        return walkable_at(o, c.on_shape, settings_.min_up) || is_step(o, foot);
    });
}

/// The normal of what the body rests on where nothing walkable does.
Vec3 CapsuleMover::resting_normal(const Vec3& foot) const {
    const Segment at = body(foot);
    Vec3 steepest = Vec3::UnitY();
    for (const Obstacle& o : obstacles_) {
        const Closest c = closest(at, o);
        if (c.distance > 0.0 && c.distance <= settings_.radius + 2.0 * kRest) {
            const Vec3 n = (c.on_segment - c.on_shape) / c.distance;
            if (n.y() > 0.0 && n.y() < steepest.y()) {
                steepest = n;
            }
        }
    }
    return steepest;
}

void CapsuleMover::walk(MoverState& state, const Vec3& wish) {
    const Vec3 start = state.foot;
    find_contacts(start, horizontal_norm(wish) + settings_.skin + kRest);
    const Vec3 flat = slide(start, wish);
    Vec3 foot = start;
    foot += free_part(foot, Vec3(0, needed_lift(start, flat), 0), settings_.radius + kHard);
    foot += free_part(foot, flat, settings_.radius + kHard);

    const Vec3 reach(0, -(foot.y() - start.y() + settings_.step_height), 0);
    const Vec3 down = free_part(foot, reach, settings_.radius + kRest);
    const bool found = down.y() > reach.y();
    if (found && supported(foot + down)) {
        state.foot = foot + down;
        return;
    }
    // Nothing to stand on: over an edge, or onto something too steep. Falling starts at the old height.
    foot.y() = std::max((foot + down).y(), std::min(start.y(), foot.y()));
    state.foot = foot;
    state.grounded = false;
    state.vertical_speed = 0.0;
    state.fall_from = start.y();
}

void CapsuleMover::fall(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace) {
    const Vec3 start = state.foot;
    find_contacts(start, horizontal_norm(wish) + settings_.skin + kRest);
    Vec3 foot = start + free_part(start, slide(start, wish), settings_.radius + kHard);

    const double rise = state.vertical_speed * seconds - 0.5 * settings_.gravity * seconds * seconds;
    const double radius = settings_.radius + (rise > 0.0 ? kHard : kRest);
    const Vec3 vertical = free_part(foot, Vec3(0, rise, 0), radius);
    foot += vertical;
    state.vertical_speed -= settings_.gravity * seconds;
    state.fall_from = std::max(state.fall_from, foot.y());
    const double rest = rise - vertical.y();
    if (rest < 0.0) {
        if (supported(foot)) {
            land(state, foot, trace);
            return;
        }
        // Too steep to stand on: what is left of the fall goes down the slope.
        const Vec3 n = resting_normal(foot);
        const Vec3 along = rest * (Vec3::UnitY() - n.y() * n);
        const Vec3 before = foot;
        find_contacts(foot, along.norm() + settings_.skin + kRest);
        foot += free_part(foot, slide(foot, Vec3(along.x(), 0, along.z())), settings_.radius + kHard);
        foot += free_part(foot, Vec3(0, along.y(), 0), settings_.radius + kRest);
        state.vertical_speed = (foot.y() - start.y()) / seconds;
        const bool wedged = (foot - before).norm() < kStill && std::abs(vertical.y()) < kStill;
        if (wedged || supported(foot)) {
            land(state, foot, trace);
            return;
        }
    } else if (rest > 0.0) {
        state.vertical_speed = 0.0;
    }
    state.foot = foot;
}

void CapsuleMover::land(MoverState& state, const Vec3& foot, MoveTrace& trace) {
    trace.landed = true;
    trace.fall_height = std::max(trace.fall_height, state.fall_from - foot.y());
    state.foot = foot;
    state.grounded = true;
    state.vertical_speed = 0.0;
}

void CapsuleMover::list_touching(const Vec3& foot, MoveTrace& trace) {
    trace.touching.clear();
    find_contacts(foot, settings_.skin + kListed);
    for (const Contact& c : contacts_) {
        if (c.kind != Kind::wall) {
            continue;
        }
        const double gap = c.closest.distance - settings_.radius;
        if (trace.touching.empty() || trace.touching.back().object != c.obstacle->object) {
            trace.touching.push_back({c.obstacle->object, gap});
        } else {
            trace.touching.back().gap = std::min(trace.touching.back().gap, gap);
        }
    }
}

void CapsuleMover::place(MoverState& state, const Vec3& foot, double search, QueryCounters& counters) {
    gather(foot, 0.0, 0.0, search, counters);
    const Vec3 down = free_part(foot, Vec3(0, -search, 0), settings_.radius + kRest);
    const bool found = down.y() > -search && supported(foot + down);
    state = MoverState{};
    state.grounded = found;
    state.foot = found ? Vec3(foot + down) : foot;
    state.fall_from = state.foot.y();
}

void CapsuleMover::touch(const MoverState& state, MoveTrace& trace, QueryCounters& counters) {
    gather(state.foot, 0.0, settings_.step_height, settings_.step_height, counters);
    list_touching(state.foot, trace);
}

void CapsuleMover::move(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace,
                        QueryCounters& counters) {
    trace.path.assign(1, state.foot);
    trace.landed = false;
    trace.fall_height = 0.0;
    const double length = wish.norm();
    const double fallen = (std::abs(state.vertical_speed) + settings_.gravity * seconds) * seconds;
    gather(state.foot, length + (state.grounded ? 0.0 : fallen), settings_.step_height + fallen,
           settings_.step_height + fallen, counters);
    // Short parts keep the tangent planes of `slide` close to the shapes they stand for.
    const double longest = 0.5 * settings_.radius;
    const int parts = std::max(1, static_cast<int>(std::ceil(length / longest)));
    for (int i = 0; i < parts; ++i) {
        const Vec3 part = wish / parts;
        if (!state.grounded) {
            fall(state, part, seconds / parts, trace);
        } else if (length > 0.0) {
            walk(state, part);
        }
        trace.path.push_back(state.foot);
    }
    list_touching(state.foot, trace);
}

}  // namespace campuswalk::collision
