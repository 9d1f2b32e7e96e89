#include "engine/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "collision/geometry/trigonometry.h"
#include "collision/world/placement.h"
#include "engine/events/decimals.h"

namespace campuswalk::engine {

using collision::Detection;
using Eigen::Vector3d;

namespace {

/// This far below everything there is, the avatar has fallen off the world, metres.
constexpr double kAbyss = 10.0;
/// Falls of less than this are steps, not landings worth an event, metres.
constexpr double kNotableFall = 0.5;
constexpr double kDegrees = 180.0 / 3.14159265358979323846;

struct EventKinds {
    EventKind enter;
    EventKind stay;
    EventKind exit;
};

EventKinds event_kinds_of(DetectionMode mode) {
    switch (mode) {
        case DetectionMode::collision:
            return {EventKind::collision_enter, EventKind::collision_stay, EventKind::collision_exit};
        case DetectionMode::trigger:
            return {EventKind::trigger_enter, EventKind::trigger_stay, EventKind::trigger_exit};
        default:
            return {EventKind::ray_enter, EventKind::ray_stay, EventKind::ray_exit};
    }
}

/// At least one.
Tick ticks_of(double seconds, const SimSettings& sim) {
    return std::max<Tick>(1, static_cast<Tick>(std::floor(seconds * sim.ticks_per_second + 0.5)));
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

collision::QueryCounters since(const collision::QueryCounters& before, const collision::QueryCounters& now) {
    return {now.nv - before.nv, now.np - before.np, now.nu - before.nu};
}

}  // namespace

Simulation::Simulation(const scene::Campus& campus, const Walk& walk)
    : campus_(campus),
      walk_(walk),
      dt_(1.0 / walk.sim.ticks_per_second),
      disabled_(campus.objects.size(), false),
      solids_{Detection::solid, ignored_layers(campus, walk.avatar), &disabled_},
      mover_(campus.world, mover_settings(walk.avatar), solids_),
      script_(walk),
      contact_detector_(campus, walk.avatar, solids_.ignored_layers, ticks_of(walk.sim.stay_every, walk.sim),
                        ticks_of(walk.sim.gaze_hold, walk.sim), &disabled_),
      popups_(campus.description.buildings.size()),
      step_expectations_(campus, walk),
      stuck_(walk.sim.ticks_per_second) {}

const TickRecord& Simulation::step() {
    ++tick_;
    events_.clear();
    snapshots_.clear();
    placed_ = nullptr;

    const Intent intent = script_.intend(avatar_);
    record_.costs = {};
    const collision::QueryCounters before_move = counters_;
    move(intent);
    record_.costs.move = since(before_move, counters_);
    if (tick_ == 0) {
        Event& start = add(EventKind::walk_start, walk_.name);
        start.fields = {{"pos", avatar_.position}, {"yaw", Decimal{avatar_.yaw * kDegrees, 1}}};
    }
    report_placement(intent);
    const collision::QueryCounters before_sense = counters_;
    contact_detector_.detect(tick_, avatar_, trace_, transitions_, counters_);
    record_.costs.detect = since(before_sense, counters_);
    report_transitions(placed_);
    report_dwelling();
    report_fall();
    report_stuck(intent);
    report_step_end();
    report_timeout();
    return finish_record();
}

const TickRecord& Simulation::leave_everything() {
    events_.clear();
    snapshots_.clear();
    record_.costs = {};
    contact_detector_.leave_all(tick_, transitions_);
    report_transitions("end");
    return finish_record();
}

void Simulation::move(const Intent& intent) {
    if (intent.placement) {
        leave_place(intent.placement->kind == EventKind::avatar_teleport ? "teleport" : "spawn");
        set_down(intent.placement->foot, *intent.placement->label);
    } else {
        jumped_ = (intent.jump && mover_.jump(body_, *intent.jump)) || jumped_;
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

/// What is met ends where the avatar was.
void Simulation::leave_place(const char* cause) {
    placed_ = cause;
    jumped_ = false;
    if (tick_ > 0) {
        contact_detector_.leave_all(tick_, transitions_);
        report_transitions(cause);
    }
}

/// Puts the body down at a place, or beside what is in the way there.
void Simulation::set_down(const Vector3d& foot, const std::string& label) {
    // check_walk has refused places that can't be made free.
    const collision::Standing standing =
        collision::standing_place(campus_.world, solids_, foot, walk_.avatar.radius, mover_.height(),
                                  kPlacementSearch, counters_)
            .value_or(collision::Standing{foot, std::nullopt});
    if (standing.pushed_out_of) {
        push_ = Push{label, foot, (standing.foot - foot).norm(), *standing.pushed_out_of};
    }
    mover_.place(body_, standing.foot, 2.0 * kPlacementSearch, counters_);
    stay_where_it_is();
}

/// The trace of a body that doesn't move.
void Simulation::stay_where_it_is() {
    trace_.path.assign(1, body_.foot);
    trace_.landed = false;
    mover_.touch(body_, trace_, counters_);
}

void Simulation::report_placement(const Intent& intent) {
    if (intent.placement && tick_ > 0) {
        Event& event = add(intent.placement->kind, *intent.placement->label);
        event.fields = {{"pos", body_.foot}, {"yaw", Decimal{intent.yaw * kDegrees, 1}}};
    }
    report_push();
    if (intent.jump && jumped_) {
        add(EventKind::avatar_jump, walk_.name).fields = {{"pos", trace_.path.front()},
                                                          {"speed", Decimal{*intent.jump, 3}}};
    }
}

void Simulation::report_transitions(const char* cause) {
    for (const DetectedTransition& detected : transitions_) {
        report_transition(detected, cause);
    }
}

/// The event of a transition and, when it is the first or the last of its building, the pop-up's: opened
/// after the enter, closed before the exit.
void Simulation::report_transition(const DetectedTransition& detected, const char* cause) {
    const Transition& t = detected.transition;
    const scene::CampusObject& object = campus_.objects[index_of(t.object)];
    const EventKinds kinds = event_kinds_of(detected.mode);
    const bool shows = object.popup && object.building;

    if (t.phase == Phase::exit && shows) {
        leave_popup(detected);
    }
    const EventKind kind = t.phase == Phase::enter  ? kinds.enter
                           : t.phase == Phase::stay ? kinds.stay
                                                    : kinds.exit;
    Event& event = add(kind, object.id, t.at);
    event.fields.push_back({"pos", position_at(t.at)});
    if (detected.mode == DetectionMode::trigger && t.phase != Phase::stay && cause == nullptr) {
        event.fields.push_back({"at", Decimal{t.at, 3}});
    }
    if (detected.mode == DetectionMode::ray && t.phase != Phase::exit) {
        event.fields.push_back({"distance", Decimal{detected.distance, 3}});
    }
    if (t.phase != Phase::enter) {
        event.fields.push_back({"ticks", static_cast<std::int64_t>(t.ticks)});
    }
    if (cause != nullptr && t.phase != Phase::stay) {
        event.fields.push_back({"cause", std::string(cause)});
    }
    if (t.phase == Phase::enter && shows) {
        meet_popup(detected);
    }
}

void Simulation::report_fall() {
    if (trace_.landed && (jumped_ || trace_.fall_height >= kNotableFall)) {
        add(EventKind::avatar_landed, walk_.name).fields = {{"pos", avatar_.position},
                                                            {"height", Decimal{trace_.fall_height, 3}}};
    }
    jumped_ = jumped_ && !body_.grounded;
    if (avatar_.position.y() < campus_.world.bounds().min.y() - kAbyss) {
        add(EventKind::avatar_fell, walk_.name).fields = {{"pos", avatar_.position}};
        end_walk(walk_.mark, "fell", "the avatar fell off the world");
    }
}

void Simulation::report_stuck(const Intent& intent) {
    if (!stuck_.see(avatar_.position, intent.move.norm())) {
        return;
    }
    Event& event = add(EventKind::avatar_stuck, walk_.name);
    event.fields.push_back({"pos", avatar_.position});
    if (std::string by = obstacle(); !by.empty()) {
        event.fields.push_back({"by", std::move(by)});
    }
}

/// The object beside the avatar that is nearest to it; empty when nothing is.
std::string Simulation::obstacle() const {
    if (trace_.touching.empty()) {
        return "";
    }
    const auto nearest = std::ranges::min_element(trace_.touching, {}, &collision::Touch::gap);
    return campus_.objects[index_of(nearest->object)].id;
}

void Simulation::report_step_end() {
    script_.hear(events_);
    effects_.clear();
    const std::optional<StepEnd> end = script_.settle(avatar_, effects_);
    if (end) {
        const std::string by = end->kind == EventKind::avatar_blocked ? obstacle() : "";
        if (end->kind) {
            Event& event = add(*end->kind, *end->label);
            event.fields.push_back({"pos", avatar_.position});
            if (!by.empty()) {
                event.fields.push_back({"by", by});
            }
        }
        if (end->fatal) {
            end_walk(*end->mark, end->code, end->message + (by.empty() ? "" : ": blocked by " + by));
        }
    }
    const std::size_t heard = events_.size();
    for (const Step* effect : effects_) {
        apply(*effect);
    }
    script_.hear(std::span(events_).subspan(heard));
    finished_ = finished_ || script_.finished();
}

/// However the walk is going: a time-out is none of the script's steps.
void Simulation::report_timeout() {
    constexpr double kRounding = 1e-9;  // ticks
    const bool over = walk_.timeout &&
                      static_cast<double>(tick_) >= *walk_.timeout * walk_.sim.ticks_per_second - kRounding;
    if (over && !finished_) {
        end_walk(script_.mark(), "timeout",
                 "the walk was still in this step after " + fixed(*walk_.timeout, 3) + " s, its time-out");
    }
}

const TickRecord& Simulation::finish_record() {
    hash_.add(avatar_.position);
    for (const Event& event : events_) {
        add_event(hash_, event);
    }
    fill_record();
    step_expectations_.see(record_);
    return record_;
}

void Simulation::fill_record() {
    record_.tick = tick_;
    record_.time = static_cast<double>(tick_) / walk_.sim.ticks_per_second;
    record_.avatar = avatar_;
    record_.events = events_;
    record_.snapshots = snapshots_;
    record_.distance = distance_;
    record_.open_popups = windows_;
    record_.disabled = &disabled_;
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
    stop_ = Stop{mark, std::move(code), std::move(message), std::nullopt};
    finished_ = true;
    script_.abandon();
}

}  // namespace campuswalk::engine
