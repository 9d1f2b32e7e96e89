#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/placement.h"
#include "collision/trigonometry.h"

namespace campuswalk::engine {

using collision::Detection;
using collision::QueryFilter;
using Eigen::Vector3d;

namespace {

/// This far below everything there is, the avatar has fallen off the world, metres.
constexpr double kAbyss = 10.0;
/// Falls of less than this are steps, not landings worth an event, metres.
constexpr double kNotableFall = 0.5;
constexpr double kDegrees = 180.0 / 3.14159265358979323846;

struct KindsOf {
    EventKind enter;
    EventKind stay;
    EventKind exit;
};

KindsOf kinds_of(Strategy strategy) {
    switch (strategy) {
        case Strategy::collision:
            return {EventKind::collision_enter, EventKind::collision_stay, EventKind::collision_exit};
        case Strategy::trigger:
            return {EventKind::trigger_enter, EventKind::trigger_stay, EventKind::trigger_exit};
        default:
            return {EventKind::ray_enter, EventKind::ray_stay, EventKind::ray_exit};
    }
}

Tick stay_ticks(const SimSettings& sim) {
    return std::max<Tick>(1, static_cast<Tick>(std::floor(sim.stay_every * sim.ticks_per_second + 0.5)));
}

std::string popup_body(const scene::Building& building) {
    std::string body = building.hours.empty() ? "" : "Open " + building.hours + ".";
    if (!building.text.empty()) {
        body += (body.empty() ? "" : " ") + building.text;
    }
    return body;
}

void add_value(StateHash& hash, std::int64_t value) {
    hash.add(static_cast<std::uint64_t>(value));
}
void add_value(StateHash& hash, const Decimal& value) {
    hash.add(value.value);
}
void add_value(StateHash& hash, const Vector3d& value) {
    hash.add(value);
}
void add_value(StateHash& hash, const std::string& value) {
    hash.add(std::string_view(value));
}
void add_value(StateHash& hash, const Text& value) {
    hash.add(std::string_view(value.value));
}

void add_event(StateHash& hash, const Event& event) {
    hash.add(static_cast<std::uint64_t>(event.kind));
    hash.add(event.at);
    hash.add(std::string_view(event.object));
    for (const Field& field : event.fields) {
        hash.add(field.name);
        std::visit([&](const auto& value) { add_value(hash, value); }, field.value);
    }
}

}  // namespace

collision::MoverSettings mover_settings(const AvatarProfile& avatar) {
    collision::MoverSettings settings;
    settings.height = avatar.height;
    settings.radius = avatar.radius;
    settings.step_height = avatar.step_height;
    settings.min_up = collision::sin_cos(avatar.max_slope).cos;
    settings.skin = avatar.skin_width;
    return settings;
}

std::uint32_t ignored_layers(const scene::Campus& campus, const AvatarProfile& avatar) {
    std::uint32_t bits = 0;
    for (const std::string& layer : avatar.ignore_layers) {
        bits |= 1U << campus.layer_index(layer);
    }
    return bits;
}

Simulation::Simulation(const scene::Campus& campus, const Walk& walk)
    : campus_(campus),
      walk_(walk),
      dt_(1.0 / walk.sim.ticks_per_second),
      solids_{Detection::solid, ignored_layers(campus, walk.avatar)},
      mover_(campus.world, mover_settings(walk.avatar), solids_),
      script_(walk),
      senses_(campus, walk.avatar, solids_.ignored_layers, stay_ticks(walk.sim)),
      popups_(campus.description.buildings.size()) {}

const FrameRecord& Simulation::step() {
    ++tick_;
    events_.clear();
    snapshots_.clear();
    placed_ = nullptr;

    const Intent intent = script_.intend(avatar_);
    move(intent);
    if (tick_ == 0) {
        Event& start = add(EventKind::walk_start, walk_.name);
        start.fields = {{"pos", avatar_.position}, {"yaw", Decimal{avatar_.yaw * kDegrees, 1}}};
    }
    senses_.sense(tick_, avatar_, trace_, transitions_, counters_);
    report_transitions(placed_);
    report_fall();
    report_step_end();
    return finish_record();
}

const FrameRecord& Simulation::leave_everything() {
    events_.clear();
    snapshots_.clear();
    senses_.leave_all(tick_, transitions_);
    report_transitions("end");
    return finish_record();
}

void Simulation::move(const Intent& intent) {
    if (intent.placement) {
        put(*intent.placement, intent.yaw);
    } else {
        mover_.move(body_, intent.move, dt_, trace_, counters_);
        for (std::size_t i = 1; i < trace_.path.size(); ++i) {
            distance_ += (trace_.path[i] - trace_.path[i - 1]).norm();
        }
    }
    avatar_.position = body_.foot;
    avatar_.vertical_speed = body_.vertical_speed;
    avatar_.grounded = body_.grounded;
    avatar_.yaw = intent.yaw;
    avatar_.pitch = intent.pitch;
}

void Simulation::put(const Intent::Placement& placement, double yaw) {
    const bool teleported = placement.kind == EventKind::avatar_teleport;
    placed_ = teleported ? "teleport" : "spawn";
    if (tick_ > 0) {  // what is met ends where the avatar was
        senses_.leave_all(tick_, transitions_);
        report_transitions(placed_);
    }
    const AvatarProfile& a = walk_.avatar;
    // check_walk has refused places that aren't free.
    const Vector3d foot = collision::free_place(campus_.world, solids_, placement.foot, a.radius, a.height,
                                                kPlacementSearch, counters_)
                              .value_or(placement.foot);
    mover_.place(body_, foot, 2.0 * kPlacementSearch, counters_);
    trace_.path.assign(1, body_.foot);
    trace_.landed = false;
    mover_.touch(body_, trace_, counters_);
    if (tick_ > 0) {
        Event& event = add(placement.kind, *placement.label);
        event.fields = {{"pos", body_.foot}, {"yaw", Decimal{yaw * kDegrees, 1}}};
    }
}

void Simulation::report_transitions(const char* cause) {
    for (const SensedTransition& sensed : transitions_) {
        report_transition(sensed, cause);
    }
}

/// The event of a transition and, when it is the first or the last of its building, the pop-up's: opened
/// after the enter, closed before the exit.
void Simulation::report_transition(const SensedTransition& sensed, const char* cause) {
    const Transition& t = sensed.transition;
    const scene::CampusObject& object = campus_.objects[index_of(t.object)];
    const KindsOf kinds = kinds_of(sensed.strategy);
    const bool shows = object.popup && object.building;

    if (t.phase == Phase::exit && shows && popups_.leave(*object.building)) {
        add(EventKind::popup_close, campus_.description.buildings[*object.building].id, t.at);
    }
    const EventKind kind = t.phase == Phase::enter  ? kinds.enter
                           : t.phase == Phase::stay ? kinds.stay
                                                    : kinds.exit;
    Event& event = add(kind, object.id, t.at);
    event.fields.push_back({"pos", position_at(t.at)});
    if (sensed.strategy == Strategy::trigger && t.phase != Phase::stay && cause == nullptr) {
        event.fields.push_back({"at", Decimal{t.at, 3}});
    }
    if (sensed.strategy == Strategy::ray && t.phase != Phase::exit) {
        event.fields.push_back({"distance", Decimal{sensed.distance, 3}});
    }
    if (t.phase != Phase::enter) {
        event.fields.push_back({"ticks", static_cast<std::int64_t>(t.ticks)});
    }
    if (cause != nullptr && t.phase != Phase::stay) {
        event.fields.push_back({"cause", std::string(cause)});
    }
    if (t.phase == Phase::enter && shows && popups_.meet(*object.building)) {
        const scene::Building& building = campus_.description.buildings[*object.building];
        add(EventKind::popup_open, building.id, t.at).fields = {{"title", Text{building.title}},
                                                                {"body", Text{popup_body(building)}}};
    }
}

void Simulation::report_fall() {
    if (trace_.landed && trace_.fall_height >= kNotableFall) {
        add(EventKind::avatar_land, walk_.name).fields = {{"pos", avatar_.position},
                                                          {"height", Decimal{trace_.fall_height, 3}}};
    }
    if (avatar_.position.y() < campus_.world.bounds().min.y() - kAbyss) {
        add(EventKind::avatar_fell, walk_.name).fields = {{"pos", avatar_.position}};
        end_walk(walk_.mark, "fell", "the avatar fell off the world");
    }
}

void Simulation::report_step_end() {
    const std::optional<StepEnd> end = script_.settle(avatar_, snapshots_);
    if (end) {
        Event& event = add(end->kind, *end->label);
        event.fields.push_back({"pos", avatar_.position});
        std::string by;
        if (end->kind == EventKind::avatar_blocked && !trace_.touching.empty()) {
            const auto nearest = std::ranges::min_element(trace_.touching, {}, &collision::Touch::gap);
            by = campus_.objects[index_of(nearest->object)].id;
            event.fields.push_back({"by", by});
        }
        if (end->fatal) {
            end_walk(*end->mark, "blocked",
                     "walk_to " + *end->label + " was not reached" + end->why +
                         (by.empty() ? "" : ": blocked by " + by));
        }
    }
    for (const SnapshotStep* snapshot : snapshots_) {
        add(EventKind::snapshot_take, snapshot->name).fields = {{"pos", avatar_.position}};
    }
    finished_ = finished_ || script_.finished();
}

const FrameRecord& Simulation::finish_record() {
    hash_.add(avatar_.position);
    for (const Event& event : events_) {
        add_event(hash_, event);
    }
    record_.tick = tick_;
    record_.time = static_cast<double>(tick_) / walk_.sim.ticks_per_second;
    record_.avatar = avatar_;
    record_.events = events_;
    record_.snapshots = snapshots_;
    record_.open_popups = popups_.open();
    return record_;
}

/// On the polyline that the tick went along.
Vector3d Simulation::position_at(double fraction) const {
    const std::size_t parts = trace_.path.size() - 1;
    if (parts == 0) {
        return trace_.path.front();
    }
    const double along = fraction * static_cast<double>(parts);
    const std::size_t part = std::min(parts - 1, static_cast<std::size_t>(along));
    const double rest = along - static_cast<double>(part);
    return trace_.path[part] + rest * (trace_.path[part + 1] - trace_.path[part]);
}

Event& Simulation::add(EventKind kind, std::string object, double at) {
    Event event;
    event.tick = tick_;
    event.at = at;
    event.kind = kind;
    event.object = std::move(object);
    events_.push_back(std::move(event));
    return events_.back();
}

void Simulation::end_walk(const SourceMark& mark, std::string code, std::string message) {
    stop_ = Stop{mark, std::move(code), std::move(message)};
    finished_ = true;
    script_.abandon();
}

}  // namespace campuswalk::engine
