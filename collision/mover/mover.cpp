#include "collision/mover/mover.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "collision/mover/upright_distance.h"

namespace campuswalk::collision {

namespace {

/// How far beyond the skin touching objects are still listed, for the hysteresis of events, metres.
constexpr double kListed = 0.01;
/// Points that a floor may share with what the body touches lie no farther outside its reach, metres.
constexpr double kSurroundings = 0.05;
constexpr double kStill = 1e-9;
/// Whoever is held back to this share of what was asked for stands still: what is left of the way along a
/// wall becomes ever shorter, and would never end.
constexpr double kCreep = 1e-5;

/// The nearest of each object counts.
void note(const Touch& touch, std::vector<Touch>& touching) {
    const auto at = std::ranges::lower_bound(touching, touch.object, {}, &Touch::object);
    if (at == touching.end() || at->object != touch.object) {
        touching.insert(at, touch);
    } else {
        at->gap = std::min(at->gap, touch.gap);
    }
}

double horizontal_norm(const Vec3& v) {
    return std::sqrt(v.x() * v.x() + v.z() * v.z());
}

}  // namespace

CapsuleMover::CapsuleMover(const World& world, const MoverSettings& settings, const QueryFilter& filter)
    : settings_(settings),
      around_(world, settings, filter),
      ground_query_(settings),
      steepest_(std::sqrt(1.0 - settings.min_up * settings.min_up) / settings.min_up) {}

void CapsuleMover::move(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace,
                        QueryStatistics* statistics) {
    trace.path.assign(1, state.foot);
    trace.landed = false;
    trace.fall_height = 0.0;
    if (stays(state, wish, seconds, trace)) {
        return;
    }
    const MoverState before = state;
    // In parts this short, an edge of a flat wall is never met by a body that keeps the skin from the wall.
    const double longest =
        std::max(0.99 * std::sqrt(2.0 * settings_.radius * settings_.skin), 0.1 * settings_.radius);
    const double length = horizontal_norm(wish) + horizontal_norm(state.drift) * seconds;
    const int parts = std::max(1, static_cast<int>(std::ceil(length / longest)));
    if (parts > 1) {
        look_around(state.foot, length, settings_.step_height, settings_.step_height, statistics);
    }
    for (int i = 0; i < parts; ++i) {
        move_part(state, wish / parts, seconds / parts, trace, statistics);
        trace.path.push_back(state.foot);
    }
    list_touching(state, trace);
    still_.known = state == before && !trace.landed;
    if (still_.known) {
        still_.state = state;
        still_.wish = wish;
        still_.seconds = seconds;
        still_.places = trace.path.size();
        still_.touching = trace.touching;
    }
}

bool CapsuleMover::stays(const MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace) const {
    if (!still_.known || still_.wish != wish || still_.seconds != seconds || !(still_.state == state)) {
        return false;
    }
    trace.path.assign(still_.places, state.foot);
    trace.touching = still_.touching;
    return true;
}

void CapsuleMover::forget() {
    around_.forget();
    still_.known = false;
}

Support CapsuleMover::support_of(const MoverState& state) const {
    const double foot_y = state.foot.y();
    const bool known = state.grounded && state.carried_at <= foot_y + settings_.radius;
    return {state.foot, known ? std::max(foot_y, state.carried_at) : foot_y};
}

void CapsuleMover::move_part(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace,
                             QueryStatistics* statistics) {
    const double length = horizontal_norm(wish) + horizontal_norm(state.drift) * seconds;
    if (state.grounded) {
        const double above = support_of(state).base - state.foot.y();
        const double high = std::max(settings_.step_height + above, steepest_ * length) + 2.0 * kHeightSlack;
        look_around(state.foot, length, high, high, statistics);
        if (length > 0.0) {
            walk(state, wish);
        }
        return;
    }
    const double high =
        (std::abs(state.vertical_speed) + settings_.gravity * seconds) * seconds + kHeightSlack;
    look_around(state.foot, length + high, high, high, statistics);
    fall(state, wish, seconds, trace);
}

/// Surveys what the body may meet this far from its place.
void CapsuleMover::look_around(const Vec3& foot, double sideways, double up, double down,
                               QueryStatistics* statistics) {
    const double beside = sideways + GroundQuery::kProbe;
    const double reach = settings_.radius + beside + settings_.skin + kSurroundings;
    const Vec3 low(reach, down + kSurroundings + settings_.skin, reach);
    const Vec3 high(reach, settings_.height + up + kSurroundings + settings_.skin, reach);
    around_.cover({foot - low, foot + high}, statistics);
    around_.survey(foot, beside, up, down, settings_.skin + kListed);
}

void CapsuleMover::find_walls(const Support& stand, double length, bool grounded) {
    const Vec3& foot = stand.foot;
    constexpr double kVertical = 1e-6;
    planes_.clear();
    edges_.clear();
    const double reach = settings_.radius + settings_.skin + length + kRest;
    const double highest_edge = foot.y() + settings_.step_height;
    for (const ContactCache::Index i : around_.near()) {
        const ContactCache::Piece& piece = around_.piece(i);
        if ((grounded && piece.walkable && piece.obstacle.top <= highest_edge) ||
            around_.known_apart(i, foot, foot, reach)) {
            continue;
        }
        const Separation s = around_.separation(i, foot);
        const double flat = horizontal_norm(s.normal);
        if (s.distance > reach || flat <= kVertical) {
            continue;
        }
        const bool wall =
            grounded ? ground_query_.kind(around_, i, stand) == Kind::wall : s.normal.y() < settings_.min_up;
        if (!wall) {
            continue;
        }
        if (s.feature == Feature::face) {
            const double room = std::max(0.0, s.distance - settings_.radius - settings_.skin);
            planes_.push_back({s.normal.x() / flat, s.normal.z() / flat, room / flat});
        } else {
            edges_.push_back(i);
        }
    }
}

/// Holds the wish against the walls. Flat walls always count; an edge counts only once the move would run
/// into it, because an edge between two flush faces isn't there for the avatar.
Vec3 CapsuleMover::slide(const Support& stand, const Vec3& wish, bool grounded) {
    const Vec3& foot = stand.foot;
    find_walls(stand, horizontal_norm(wish), grounded);
    while (true) {
        Vec3 move = nearest_allowed(wish, planes_);
        const auto met = std::partition(edges_.begin(), edges_.end(),
                                        [&](ContactCache::Index i) { return !way().meets(i, foot, move); });
        if (met == edges_.end()) {
            return move;
        }
        for (auto i = met; i != edges_.end(); ++i) {
            const Separation& s = around_.separation(*i, foot);
            const double flat = horizontal_norm(s.normal);
            const double room = std::max(0.0, s.distance - settings_.radius - kRest);
            planes_.push_back({s.normal.x() / flat, s.normal.z() / flat, room / flat});
        }
        edges_.erase(met, edges_.end());
    }
}

Ground CapsuleMover::underfoot(const Vec3& foot) {
    return ground_query_.ground(around_, foot.x(), foot.z(), {foot, foot.y()}, 4.0 * kRest, 4.0 * kRest);
}

void CapsuleMover::walk(MoverState& state, const Vec3& wish) {
    const Support stand = support_of(state);
    const Vec3& start = stand.foot;
    Vec3 flat = slide(stand, wish, true);
    if (flat.squaredNorm() < kCreep * kCreep * wish.squaredNorm()) {
        flat = Vec3::Zero();
    }
    const double slope = steepest_ * horizontal_norm(flat) + kHeightSlack;
    const double up = std::max(settings_.step_height + kHeightSlack + stand.base - start.y(), slope);
    const double down = std::max(settings_.step_height + kHeightSlack, slope);
    const Ground ahead =
        ground_query_.ground(around_, start.x() + flat.x(), start.z() + flat.z(), stand, up, down);
    if (ahead.carries) {
        const Vec3 goal(start.x() + flat.x(), ahead.foot_y, start.z() + flat.z());
        if (way().is_free(start, goal) || way().is_free_over(start, goal)) {
            state.foot = goal;
            state.carried_at = ahead.at;
            return;
        }
    }
    walk_as_far_as_free(state, flat, ahead);
}

/// Where something is in the way, or nothing to stand on.
void CapsuleMover::walk_as_far_as_free(MoverState& state, const Vec3& flat, const Ground& ahead) {
    const double radius = settings_.radius + kHard;
    const Support stand = support_of(state);
    const Vec3& start = stand.foot;
    Vec3 foot = start;
    if (ahead.carries && ahead.foot_y > start.y()) {
        foot += way().free_part(foot, Vec3(0, ahead.foot_y - start.y() + kHard, 0), radius);
    }
    foot += way().free_part(foot, flat, radius);
    const Ground below =
        ground_query_.ground(around_, foot.x(), foot.z(), stand, foot.y() - start.y() + kHard,
                             settings_.step_height + kHeightSlack);
    const double lower = std::min(0.0, (below.carries ? below.foot_y : start.y()) - foot.y());
    foot += way().free_part(foot, Vec3(0, lower, 0), radius);
    state.foot = foot;
    if (below.carries && foot.y() <= below.foot_y + kRest) {
        state.carried_at = below.at;
        return;
    }
    // Over an edge, or onto something too steep. Falling starts at the old height.
    state.leave_ground(0.0, start.y());
}

void CapsuleMover::fall(MoverState& state, const Vec3& wish, double seconds, MoveTrace& trace) {
    const Vec3 start = state.foot;
    const double rise = state.vertical_speed * seconds - 0.5 * settings_.gravity * seconds * seconds;
    Vec3 foot = start;
    Vec3 vertical = Vec3::Zero();
    if (rise > 0.0) {
        vertical = way().free_part(foot, Vec3(0, rise, 0), settings_.radius + kHard);
        foot += vertical;
    }
    const Vec3 across = slide({foot, foot.y()}, wish + seconds * state.drift, false);
    foot += way().free_part(foot, across, settings_.radius + kHard);
    hold_drift(state, seconds);
    if (rise <= 0.0) {
        vertical = way().free_part(foot, Vec3(0, rise, 0), settings_.radius + kRest);
        foot += vertical;
    }
    state.vertical_speed -= settings_.gravity * seconds;
    state.fall_from = std::max(state.fall_from, foot.y());
    const double rest = rise - vertical.y();
    if (rest > 0.0) {
        state.vertical_speed = 0.0;
    } else if (rest < 0.0) {
        if (const Ground ground = underfoot(foot); ground.carries) {
            land(state, foot, ground, trace);
            return;
        }
        const Vec3 before = foot;
        const Vec3 n = resting_normal(foot);
        foot = fall_along(foot, n, rest);
        turn_along(state, n, (foot - start).norm(), seconds);
        const bool wedged = (foot - before).norm() < kStill && std::abs(vertical.y()) < kStill;
        if (const Ground ground = underfoot(foot); wedged || ground.carries) {
            land(state, foot, ground, trace);
            return;
        }
    }
    state.foot = foot;
}

/// Too steep to stand on: what is left of the fall goes down the slope.
Vec3 CapsuleMover::fall_along(const Vec3& foot, const Vec3& n, double rest) {
    const Vec3 along = rest * (Vec3::UnitY() - n.y() * n);
    const Vec3 flat = slide({foot, foot.y()}, Vec3(along.x(), 0, along.z()), false);
    const Vec3 across = foot + way().free_part(foot, flat, settings_.radius + kHard);
    return across + way().free_part(across, Vec3(0, along.y(), 0), settings_.radius + kRest);
}

/// And so does the speed, but for what goes into the slope: without friction. Whoever is held up by something
/// else as well is no faster for having wanted to be.
void CapsuleMover::turn_along(MoverState& state, const Vec3& n, double moved, double seconds) const {
    Vec3 velocity = state.drift + Vec3(0, state.vertical_speed, 0);
    velocity -= std::min(0.0, velocity.dot(n)) * n;
    const double most = moved / seconds + settings_.gravity * seconds;
    if (const double speed = velocity.norm(); speed > most) {
        velocity *= most / speed;
    }
    state.drift = Vec3(velocity.x(), 0, velocity.z());
    state.vertical_speed = velocity.y();
}

/// Walls stop the drift, as they stop the wish: those of the last `slide`.
void CapsuleMover::hold_drift(MoverState& state, double seconds) const {
    const Vec3 own = seconds * state.drift;
    if (const Vec3 left = nearest_allowed(own, planes_); left != own) {
        state.drift = left / seconds;
    }
}

/// The steepest of what the body rests on.
Vec3 CapsuleMover::resting_normal(const Vec3& foot) {
    Vec3 steepest = Vec3::UnitY();
    const auto key = [](const Vec3& n) { return std::tuple(n.y(), n.x(), n.z()); };
    for (const ContactCache::Index i : around_.near()) {
        const Separation& s = around_.separation(i, foot);
        const bool touches = s.distance > 0.0 && s.distance <= settings_.radius + 2.0 * kRest;
        if (touches && s.normal.y() > 0.0 && key(s.normal) < key(steepest)) {
            steepest = s.normal;
        }
    }
    return steepest;
}

void CapsuleMover::land(MoverState& state, const Vec3& foot, const Ground& ground, MoveTrace& trace) {
    trace.landed = true;
    trace.fall_height = std::max(trace.fall_height, state.fall_from - foot.y());
    state.foot = foot;
    state.grounded = true;
    state.carried_at = ground.at;
    state.vertical_speed = 0.0;
    state.drift = Vec3::Zero();
}

void CapsuleMover::list_touching(const MoverState& state, MoveTrace& trace) {
    trace.touching.clear();
    const Support stand = support_of(state);
    const Vec3& foot = stand.foot;
    const double reach = settings_.radius + settings_.skin + kListed;
    const double highest_edge = foot.y() + settings_.step_height;
    for (const ContactCache::Index i : around_.near()) {
        const ContactCache::Piece& piece = around_.piece(i);
        if ((piece.walkable && piece.obstacle.top <= highest_edge) ||
            around_.known_apart(i, foot, foot, reach)) {
            continue;
        }
        const double distance = around_.separation(i, foot).distance;
        if (distance > reach || ground_query_.kind(around_, i, stand) != Kind::wall) {
            continue;
        }
        note(Touch{piece.obstacle.object, distance - settings_.radius}, trace.touching);
    }
}

void CapsuleMover::place(MoverState& state, const Vec3& foot, double search, QueryStatistics* statistics) {
    look_around(foot, 0.0, kHeightSlack, search + kHeightSlack, statistics);
    const Vec3 down = way().free_part(foot, Vec3(0, -search, 0), settings_.radius + kRest);
    const Ground ground = underfoot(foot + down);
    state = MoverState{};
    state.grounded = down.y() > -search && ground.carries;
    state.foot = state.grounded ? Vec3(foot + down) : foot;
    state.carried_at = ground.at;
    state.fall_from = state.foot.y();
}

bool CapsuleMover::jump(MoverState& state, double speed) const {
    if (!state.grounded) {
        return false;
    }
    state.leave_ground(speed, state.foot.y());
    return true;
}

bool CapsuleMover::resize(MoverState& state, double height, QueryStatistics* statistics) {
    const Segment old_core = settings_.core(state.foot);
    const double old_height = settings_.height;
    const auto change = [&](double to) {
        settings_.height = to;
        still_.known = false;
        around_.resize(to);
        ground_query_.resize(to);
    };
    change(height);
    look_around(state.foot, 0.0, kHeightSlack, kHeightSlack, statistics);
    const auto near = around_.near();
    const bool room = std::all_of(near.begin(), near.end(), [&](ContactCache::Index i) {
        const double distance = around_.separation(i, state.foot).distance;
        return distance >= settings_.radius + kHard ||
               distance >= closest_upright(old_core, around_.piece(i).obstacle).distance;
    });
    if (!room) {
        change(old_height);
    }
    return room;
}

void CapsuleMover::touch(const MoverState& state, MoveTrace& trace, QueryStatistics* statistics) {
    const double high = support_of(state).base - state.foot.y() + settings_.step_height + kHeightSlack;
    look_around(state.foot, 0.0, high, high, statistics);
    list_touching(state, trace);
}

}  // namespace campuswalk::collision
