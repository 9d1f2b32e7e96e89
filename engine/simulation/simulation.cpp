#include "engine/simulation/simulation.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "engine/events/decimals.h"
#include "engine/script/resolve_targets.h"
#include "engine/script/travel.h"
#include "engine/simulation/instant_steps.h"

namespace campuswalk::engine {

namespace {

/// What changes contacts besides the avatar's own motion; null if nothing does.
const char* cause_of(const Intent& intent) {
    return !intent.placement                                      ? nullptr
           : intent.placement->kind == EventKind::avatar_teleport ? "teleport"
                                                                  : "spawn";
}

/// Where a step goes straight to.
struct StepGoal {
    const Target* target = nullptr;
    double within = 0.0;
};

std::optional<StepGoal> goal_of(const Step& step) {
    if (const auto* walk_to = std::get_if<WalkToStep>(&step)) {
        return StepGoal{&walk_to->target, walk_to->within};
    }
    if (const auto* follow = std::get_if<FollowStep>(&step)) {
        return StepGoal{&follow->points.back(), follow->within};
    }
    return std::nullopt;
}

}  // namespace

Simulation::Simulation(const scene::Campus& campus, const Walk& walk, RouteMemory* memory)
    : state_(campus, walk),
      routes_(campus, walk.sim, state_.body, memory),
      script_(std::in_place, walk, &routes_),
      intents_(*script_) {
    if (!is_resolved(walk)) {
        throw std::invalid_argument("resolve_targets hasn't completed the walk");
    }
}

Simulation::Simulation(const scene::Campus& campus, const Walk& walk, IntentSource& intents)
    : state_(campus, walk), routes_(campus, walk.sim, state_.body, nullptr), intents_(intents) {}

const TickRecord& Simulation::step() {
    begin_tick(state_.events.tick + 1);
    const Intent intent = intents_.intend(state_.body.state());
    const Motion motion = move(intent);
    state_.contacts.detect(state_.body, cause_of(intent), state_.events, state_.costs.detect);
    state_.popups.open_due(state_.events);
    report_motion(intent, motion);
    settle_steps();
    check_timeout();
    end_tick();
    state_.expectations.on_tick(record_);
    return record_;
}

const TickRecord& Simulation::close() {
    begin_tick(state_.events.tick);
    state_.contacts.end_all(state_.body, "end", state_.events);
    end_tick();
    // Not hashed: a walk has the same hash with and without expectations.
    state_.events.add(EventKind::walk_end, state_.walk.name);
    record_.events = state_.events.list;
    state_.expectations.on_close(record_);
    return record_;
}

void Simulation::begin_tick(Tick tick) {
    state_.events.begin(tick);
    state_.snapshots.clear();
    state_.costs = {};
}

/// When the avatar is put elsewhere, its contacts end where it was.
Motion Simulation::move(const Intent& intent) {
    TickEvents& events = state_.events;
    const std::string& name = state_.walk.name;
    if (intent.placement && events.tick > 0) {
        state_.contacts.end_all(state_.body, cause_of(intent), events);
    }
    Motion motion = state_.body.follow(intent, state_.costs.move);
    if (events.tick == 0 || intent.placement) {
        const bool start = events.tick == 0;
        events.add(start ? EventKind::walk_start : intent.placement->kind,
                   start ? name : *intent.placement->label,
                   {{"pos", state_.body.foot()}, {"yaw", Decimal{degrees(intent.yaw), 1}}});
    }
    if (motion.push) {
        state_.report_push(*motion.push, *intent.placement->label);
    }
    if (motion.jumped) {
        events.add(EventKind::avatar_jump, name,
                   {{"pos", state_.body.trace().path.front()}, {"speed", Decimal{*intent.jump, 3}}});
    }
    return motion;
}

void Simulation::report_motion(const Intent& intent, const Motion& motion) {
    const std::string& name = state_.walk.name;
    const Field pos{"pos", state_.body.foot()};
    if (motion.landed_from) {
        state_.events.add(EventKind::avatar_landed, name, {pos, {"height", Decimal{*motion.landed_from, 3}}});
    }
    if (state_.body.has_fallen_out_of_the_world()) {
        state_.events.add(EventKind::avatar_fell, name, {pos});
        stop_ = stop_of_fall();
    }
    if (motion.stuck) {
        Event& event = state_.events.add(EventKind::avatar_stuck, name, {pos});
        if (std::string by = obstacle(); !by.empty()) {
            event.fields.push_back({"by", std::move(by)});
        }
        if (const std::optional<Reason>& why = reason(intent.move)) {
            event.fields.push_back({kWhy, std::make_shared<const Reason>(*why)});
        }
    }
}

Stop Simulation::stop_of_fall() const {
    const std::vector<Step>& steps = state_.walk.steps;
    const std::size_t step = std::min(intents_.steps_over(), steps.size() - 1);
    Stop stop{mark_of(steps[step]), std::string(ExpectFell::kName), "the avatar fell out of the world"};
    const auto stood = state_.body.last_stood();
    if (!stood) {
        stop.message += "; it never stood on any ground since it was placed";
        return stop;
    }
    stop.reason = reason_of_fall(state_.campus, *stood);
    stop.at = stop.reason ? *stop.reason->at : stood->at.foot;
    stop.message +=
        (stop.reason ? " " + text_of(*stop.reason) : "") + "; it last stood at " + coordinates_text(*stop.at);
    if (const auto goal = goal_of(steps[step])) {
        stop.route = routes_.route_round(*goal->target, goal->within, *stop.at);
        stop.message += stop.route ? "; from there " + text_of(*stop.route) : "";
    }
    return stop;
}

/// Ends the step that is done, and executes the instant steps after it.
void Simulation::settle_steps() {
    if (stop_) {
        return;
    }
    std::vector<Event>& events = state_.events.list;
    intents_.on_events(events);
    instant_steps_.clear();
    if (const auto end = intents_.settle(state_.body.state(), instant_steps_)) {
        report_step_end(*end);
    }
    if (instant_steps_.empty()) {
        return;
    }
    stopped_.reset();  // objects may be switched
    const std::size_t observed = events.size();
    for (const Step* step : instant_steps_) {
        if (!stop_) {
            stop_ = execute(*step, state_);
        }
    }
    intents_.on_events(std::span(events).subspan(observed));
}

void Simulation::report_step_end(const StepEnd& end) {
    const bool blocked = end.kind == EventKind::avatar_blocked;
    Stop stop{end.mark != nullptr ? *end.mark : state_.walk.mark, end.code, end.message};
    stop.object = blocked ? obstacle() : "";
    stop.reason = end.reason;
    if (blocked) {
        const Eigen::Vector3d heading = flat(end.target->point - state_.body.foot());
        stop.reason = heading.norm() > end.within ? reason(heading) : std::nullopt;
    }
    if (end.kind) {
        Event& event = state_.events.add(*end.kind, end.target->label, {{"pos", state_.body.foot()}});
        if (!stop.object.empty()) {
            event.fields.push_back({"by", stop.object});
        }
        if (stop.reason) {
            event.fields.push_back({kWhy, std::make_shared<const Reason>(*stop.reason)});
        }
    }
    if (end.fatal) {
        name_obstacle(stop);
        if (blocked) {
            stop.route = routes_.route_round(*end.target, end.within);
            stop.message += stop.route ? "; from there " + text_of(*stop.route) : "";
        }
        stop_ = std::move(stop);
    }
}

/// The walk's timeout holds whatever moves the avatar.
void Simulation::check_timeout() {
    const Walk& walk = state_.walk;
    const bool over = walk.timeout && walk.sim.has_passed(*walk.timeout, state_.events.tick);
    const bool endless = state_.events.tick >= walk.sim.max_ticks;
    if ((over || endless) && !stop_ && !intents_.finished()) {
        const SourceMark* mark = intents_.mark();
        const std::string most =
            over ? fixed(*walk.timeout, 3) + " s, its timeout"
                 : std::to_string(walk.sim.max_ticks) + " ticks, the most that are played";
        stop_ = Stop{mark != nullptr ? *mark : walk.mark, std::string(kTimeoutCode),
                     "the walk was still in this step after " + most};
    }
}

void Simulation::end_tick() {
    hash_.add(state_.body.foot());
    for (const Event& event : state_.events.list) {
        hash_.add(event);
    }
    state_.statistics += state_.costs.move;
    state_.statistics += state_.costs.detect;
    record_ = state_.record();
    record_.steps_over = intents_.steps_over();
    finished_ = stop_ || intents_.finished();
}

const std::optional<Reason>& Simulation::reason(const Eigen::Vector3d& heading) {
    const auto body = state_.body.stopped(heading);
    if (!body) {
        stopped_.reset();
        stop_reason_.reset();
        return stop_reason_;
    }
    constexpr double kSamePlace = 0.01;      // metres
    constexpr double kSameDirection = 0.99;  // cosine
    const bool same = stopped_ && (stopped_->at.foot - body->at.foot).norm() <= kSamePlace &&
                      stopped_->heading.normalized().dot(body->heading.normalized()) >= kSameDirection &&
                      stopped_->strides.body == body->strides.body;
    if (!same) {
        stop_reason_ = reason_of_stop(state_.campus, *body);
        stopped_ = body;
    }
    return stop_reason_;
}

std::string Simulation::obstacle() const {
    const auto object = state_.body.obstacle();
    return object ? state_.name_of(*object) : "";
}

}  // namespace campuswalk::engine
