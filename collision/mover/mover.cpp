#include "collision/mover/mover.h"

#include <algorithm>
#include <cmath>

#include "collision/mover/fall.h"
#include "collision/mover/ground_query.h"
#include "collision/mover/motion_clearance.h"
#include "collision/mover/upright_distance.h"
#include "collision/mover/wall_slide.h"

namespace campuswalk::collision {

namespace {

/// How far beyond the body's reach pieces are gathered, metres: a floor that ends where the body touches an
/// edge is within that.
constexpr double kSurroundings = 0.05;
/// A body that walls hold back to this share of the desired displacement stands still: the remaining motion
/// along a wall would become ever shorter and never end.
constexpr double kCreep = 1e-5;

/// Lists the smallest gap of each object.
void add_touch(const Touch& touch, std::vector<Touch>& touching) {
    const auto at = std::ranges::lower_bound(touching, touch.object, {}, &Touch::object);
    if (at == touching.end() || at->object != touch.object) {
        touching.insert(at, touch);
    } else {
        at->gap = std::min(at->gap, touch.gap);
    }
}

Support support_of(const MoverSettings& body, const MoverState& state) {
    const double foot_y = state.foot.y();
    const bool known = state.grounded && state.support_y <= foot_y + body.radius;
    return {state.foot, known ? std::max(foot_y, state.support_y) : foot_y};
}

/// A fall gathers what it will meet in its next ticks at once.
constexpr double kFallAhead = 0.5;  // metres
constexpr double kTicksAhead = 6.0;

/// Surveys what the body may touch this far from its place. It will soon be so far `below`.
void survey(MoveContext& context, const Vec3& foot, double sideways, double up, double down,
            QueryStatistics* statistics, double below = 0.0) {
    const MoverSettings& body = context.body;
    const double beside = sideways + kProbeDistance;
    const double reach = body.radius + beside + body.skin + kSurroundings;
    const Vec3 low(reach, down + kSurroundings + body.skin, reach);
    const Vec3 high(reach, body.height + up + kSurroundings + body.skin, reach);
    context.contacts.cover({foot - low, foot + high}, below, statistics);
    context.near = context.contacts.survey(foot, beside, up, down, body.skin + kListed);
    context.buffers.ground.foot.reset();
    context.buffers.ground.highest.reset();
    context.buffers.floor_end.reset();
}

/// For a body with something in the way, or nothing ahead to stand on.
void walk_as_far_as_free(MoveContext& context, MoverState& state, const Vec3& flat, const Ground& ahead) {
    const double radius = context.body.radius + kSweepGap;
    const Support stand = support_of(context.body, state);
    const Vec3& start = stand.foot;
    Vec3 foot = start;
    if (ahead.carries && ahead.foot_y > start.y()) {
        foot += free_part(context, foot, Vec3(0, ahead.foot_y - start.y() + kSweepGap, 0), radius);
    }
    foot += free_part(context, foot, flat, radius);
    const Ground below = find_ground(context, foot.x(), foot.z(), stand, foot.y() - start.y() + kSweepGap,
                                     context.body.step_height + kHeightSlack);
    const double lower = std::min(0.0, (below.carries ? below.foot_y : start.y()) - foot.y());
    foot += free_part(context, foot, Vec3(0, lower, 0), radius);
    state.foot = foot;
    if (below.carries && foot.y() <= below.foot_y + kRestGap) {
        state.support_y = below.support_y;
        return;
    }
    // Over an edge, or onto something too steep. The fall starts at the old height.
    state.leave_ground(0.0, start.y());
}

Ground ground_ahead(MoveContext& context, const Support& stand, const Vec3& flat) {
    const Vec3& start = stand.foot;
    const double slope = context.steepest * horizontal_norm(flat) + kHeightSlack;
    const double up = std::max(context.body.step_height + kHeightSlack + stand.base - start.y(), slope);
    const double down = std::max(context.body.step_height + kHeightSlack, slope);
    return find_ground(context, start.x() + flat.x(), start.z() + flat.z(), stand, up, down);
}

/// False, with nothing changed, if that isn't free.
bool walk_to_ground(MoveContext& context, MoverState& state, const Vec3& flat, const Ground& ahead) {
    const Vec3 start = state.foot;
    const Vec3 goal(start.x() + flat.x(), ahead.foot_y, start.z() + flat.z());
    if (!is_free(context, start, goal) && !is_free_over(context, start, goal) &&
        !is_free_around_edge(context, start, goal)) {
        return false;
    }
    state.foot = goal;
    state.support_y = ahead.support_y;
    return true;
}

/// Under a ceiling that slants down like the ground, a body that stayed at its height would run into it.
/// False, with nothing changed, unless the body gets by below it.
bool walk_down_under(MoveContext& context, MoverState& state, const Vec3& desired) {
    const Support stand = support_of(context.body, state);
    const Vec3 flat = slide(context, stand, desired, true, Overhangs::pass).move;
    const Ground ahead = ground_ahead(context, stand, flat);
    return ahead.carries && ahead.foot_y < stand.foot.y() && walk_to_ground(context, state, flat, ahead);
}

void walk(MoveContext& context, MoverState& state, const Vec3& desired) {
    const Support stand = support_of(context.body, state);
    const Slide along = slide(context, stand, desired, true);
    if (along.overhung && along.move != desired && walk_down_under(context, state, desired)) {
        return;
    }
    Vec3 flat = along.move;
    if (flat.squaredNorm() < kCreep * kCreep * desired.squaredNorm()) {
        flat = Vec3::Zero();
    }
    const Ground ahead = ground_ahead(context, stand, flat);
    if (!ahead.carries || !walk_to_ground(context, state, flat, ahead)) {
        walk_as_far_as_free(context, state, flat, ahead);
    }
}

/// Moves the body for one of the equal parts of a tick.
void move_part(MoveContext& context, MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace,
               QueryStatistics* statistics) {
    const double length = horizontal_norm(desired) + horizontal_norm(state.slide_velocity) * seconds;
    if (state.grounded) {
        const double above = support_of(context.body, state).base - state.foot.y();
        const double high =
            std::max(context.body.step_height + above, context.steepest * length) + 2.0 * kHeightSlack;
        survey(context, state.foot, length, high, high, statistics);
        if (length > 0.0) {
            walk(context, state, desired);
        }
        return;
    }
    const double high =
        (std::abs(state.vertical_speed) + context.body.gravity * seconds) * seconds + kHeightSlack;
    survey(context, state.foot, length + high, high, high, statistics, kFallAhead + kTicksAhead * high);
    fall(context, state, desired, seconds, trace);
}

void restart(MoveTrace& trace, std::size_t points, const Vec3& foot) {
    trace.path.assign(points, foot);
    trace.landed = false;
    trace.fall_height = 0.0;
}

/// Where the floor is open, a tick needs no queries. False elsewhere, with nothing changed.
bool walk_on_open_floor(const MoverSettings& body, OpenFloors& floors, MoverState& state, const Vec3& desired,
                        MoveTrace& trace) {
    if (!state.grounded) {
        return false;
    }
    const auto place = floors.walk(body, state.foot, desired);
    if (!place) {
        return false;
    }
    restart(trace, 1, state.foot);
    state.foot = place->foot;
    state.support_y = place->support_y;
    trace.path.push_back(state.foot);
    return true;
}

/// In parts this short, a body at skin distance from a flat wall never touches an edge of it.
double longest_part(const MoverSettings& body) {
    return std::max(0.99 * std::sqrt(2.0 * body.radius * body.skin), 0.1 * body.radius);
}

/// A tick, in equal parts.
void move_parts(MoveContext& context, MoverState& state, const Vec3& desired, double seconds,
                MoveTrace& trace, QueryStatistics* statistics) {
    restart(trace, 1, state.foot);
    const MoverSettings& body = context.body;
    const double length = horizontal_norm(desired) + horizontal_norm(state.slide_velocity) * seconds;
    const int parts = std::max(1, static_cast<int>(std::ceil(length / longest_part(body))));
    if (parts > 1) {
        survey(context, state.foot, length, body.step_height, body.step_height, statistics);
    }
    for (int i = 0; i < parts; ++i) {
        move_part(context, state, desired / parts, seconds / parts, trace, statistics);
        trace.path.push_back(state.foot);
    }
}

/// After a move that nothing was in the way of.
void learn_floor(MoveContext& context, OpenFloors& floors, const MoverState& before, const MoverState& after,
                 const Vec3& desired) {
    const Vec3& from = before.foot;
    const Vec3& to = after.foot;
    const double length = horizontal_norm(desired);
    if (before.grounded && after.grounded && to.x() == from.x() + desired.x() &&
        to.z() == from.z() + desired.z() && length > 0.0 && length <= longest_part(context.body)) {
        floors.learn(context, to, length);
    }
}

void list_touching(MoveContext& context, const MoverState& state, MoveTrace& trace) {
    trace.touching.clear();
    const Support stand = support_of(context.body, state);
    const Vec3& foot = stand.foot;
    const double reach = context.body.radius + context.body.skin + kListed;
    const double surely_floor = foot.y() + context.body.step_height;
    for (const ContactCache::Index i : context.near) {
        const ContactCache::Piece& piece = context.contacts.piece(i);
        if ((piece.walkable && piece.obstacle.top <= surely_floor) ||
            context.contacts.known_apart(i, foot, foot, reach)) {
            continue;
        }
        const double distance = context.contacts.measure(i, foot).distance;
        if (distance > reach || classify(context, i, stand) != PieceKind::wall) {
            continue;
        }
        add_touch(Touch{piece.obstacle.object, distance - context.body.radius}, trace.touching);
    }
}

/// Whether the move is the one that came to rest before. If so, it fills the trace as that one did.
bool repeats(const RestingMove& resting, const MoverState& state, const Vec3& desired, double seconds,
             MoveTrace& trace) {
    if (!resting.known || resting.desired != desired || resting.seconds != seconds ||
        !(resting.state == state)) {
        return false;
    }
    restart(trace, resting.path_points, state.foot);
    trace.touching = resting.touching;
    return true;
}

}  // namespace

void MoverCache::clear() {
    contacts.clear();
    floors.clear();
    resting.known = false;
}

CapsuleMover::CapsuleMover(const World& world, const MoverSettings& settings, const QueryFilter& filter)
    : world_(&world), settings_(settings), filter_(filter) {}

MoveContext CapsuleMover::context_with(MoverCache& cache) const {
    if (!cache.contacts.is_for(*world_, settings_, filter_)) {
        cache.clear();
        cache.contacts.prepare(*world_, settings_, filter_);
    }
    return {settings_, settings_.steepest_rise(), cache.contacts, cache.buffers, {}};
}

void CapsuleMover::move(MoverState& state, const Vec3& desired, double seconds, MoverCache& cache,
                        MoveTrace& trace, QueryStatistics* statistics) const {
    MoveContext context = context_with(cache);
    RestingMove& resting = cache.resting;
    if (repeats(resting, state, desired, seconds, trace)) {
        return;
    }
    if (walk_on_open_floor(settings_, cache.floors, state, desired, trace)) {
        trace.touching.clear();
        resting.known = false;
        return;
    }
    const MoverState before = state;
    move_parts(context, state, desired, seconds, trace, statistics);
    list_touching(context, state, trace);
    learn_floor(context, cache.floors, before, state, desired);
    resting.known = state == before && !trace.landed;
    if (resting.known) {
        resting.state = state;
        resting.desired = desired;
        resting.seconds = seconds;
        resting.path_points = trace.path.size();
        resting.touching = trace.touching;
    }
}

void CapsuleMover::advance(MoverState& state, const Vec3& desired, double seconds, MoverCache& cache,
                           MoveTrace& trace, QueryStatistics* statistics) const {
    MoveContext context = context_with(cache);
    trace.touching.clear();
    if (walk_on_open_floor(settings_, cache.floors, state, desired, trace)) {
        return;
    }
    const MoverState before = state;
    move_parts(context, state, desired, seconds, trace, statistics);
    learn_floor(context, cache.floors, before, state, desired);
}

void CapsuleMover::place(MoverState& state, const Vec3& foot, double search, MoverCache& cache,
                         QueryStatistics* statistics) const {
    MoveContext context = context_with(cache);
    survey(context, foot, 0.0, kHeightSlack, search + kHeightSlack, statistics);
    const Vec3 down = free_part(context, foot, Vec3(0, -search, 0), settings_.radius + kRestGap);
    const Ground ground = underfoot(context, foot + down, kMinSupportDrop);
    state = MoverState{};
    state.grounded = down.y() > -search && ground.carries;
    state.foot = state.grounded ? Vec3(foot + down) : foot;
    state.support_y = ground.support_y;
    state.fall_from = state.foot.y();
}

bool CapsuleMover::jump(MoverState& state, double speed) const {
    if (!state.grounded) {
        return false;
    }
    state.leave_ground(speed, state.foot.y());
    return true;
}

std::optional<CapsuleMover> CapsuleMover::resized(const MoverState& state, double height, MoverCache& cache,
                                                  QueryStatistics* statistics) const {
    const Segment old_core = settings_.core(state.foot);
    CapsuleMover other = *this;
    other.settings_.height = height;
    MoveContext context = other.context_with(cache);
    survey(context, state.foot, 0.0, kHeightSlack, kHeightSlack, statistics);
    const bool has_room = std::ranges::all_of(context.near, [&](ContactCache::Index i) {
        const double distance = cache.contacts.measure(i, state.foot).distance;
        return distance >= settings_.radius + kSweepGap ||
               distance >= closest_upright(old_core, cache.contacts.piece(i).obstacle).distance;
    });
    return has_room ? std::optional(other) : std::nullopt;
}

void CapsuleMover::touch(const MoverState& state, MoverCache& cache, MoveTrace& trace,
                         QueryStatistics* statistics) const {
    const double high =
        support_of(settings_, state).base - state.foot.y() + settings_.step_height + kHeightSlack;
    MoveContext context = context_with(cache);
    survey(context, state.foot, 0.0, high, high, statistics);
    list_touching(context, state, trace);
}

}  // namespace campuswalk::collision
