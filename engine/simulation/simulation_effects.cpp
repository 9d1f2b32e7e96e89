// What happens at the end of a tick because the script says so: the steps that take no time.

#include <algorithm>

#include "collision/world/placement.h"
#include "engine/events/decimals.h"
#include "engine/simulation/simulation.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

void Simulation::apply(const Step& step) {
    if (stop_) {
        return;  // an effect before this one ended the walk
    }
    std::visit([&](const auto& effect) { carry_out(effect); }, step);
}

void Simulation::carry_out(const SnapshotStep& step) {
    snapshots_.push_back(&step);
    add(EventKind::snapshot_take, step.name).fields = {{"pos", avatar_.position}};
}

void Simulation::carry_out(const CrouchStep& step) {
    const double before = mover_.height();
    if (step.height == before) {
        return;
    }
    if (!mover_.resize(body_, step.height, counters_)) {
        const auto object = collision::obstruction(campus_.world, solids_, body_.foot, walk_.avatar.radius,
                                                   step.height, counters_);
        const std::string by = object ? campus_.objects[index_of(*object)].id : "";
        end_walk(step.mark, "blocked",
                 "there is no head room for " + fixed(step.height, 2) + " m" +
                     (by.empty() ? "" : ": blocked by " + by));
        return;
    }
    avatar_.stature = step.height / walk_.avatar.height;
    const bool down = step.height < walk_.avatar.height;
    const EventKind kind = down ? EventKind::avatar_crouch : EventKind::avatar_stand;
    add(kind, walk_.name).fields = {{"pos", avatar_.position}, {"height", Decimal{step.height, 3}}};
}

void Simulation::carry_out(const EnableStep& step) {
    if (!switch_objects(step)) {
        return;
    }
    mover_.forget();
    if (step.enabled) {
        make_room(step);
    } else {
        drop_without_ground();
    }
    stay_where_it_is();
    report_push();
    contact_detector_.detect_again(tick_, avatar_, trace_, transitions_, counters_);
    report_transitions(step.enabled ? "enable" : "disabled");
}

/// The expectations have seen the ticks before; they are shown this one as far as it goes.
void Simulation::carry_out(const ExpectStep& step) {
    fill_record();
    if (auto failure = step_expectations_.failure(step, record_)) {
        end_walk(failure->mark, std::move(failure->code), std::move(failure->message));
        stop_->scene = std::move(failure->scene);
    }
}

/// A body at rest doesn't look for its ground again by itself.
void Simulation::drop_without_ground() {
    collision::MoverState probe;
    mover_.place(probe, body_.foot, 0.01, counters_);
    if (body_.grounded && !probe.grounded) {
        body_.leave_ground(0.0, body_.foot.y());
        avatar_.grounded = false;
    }
}

/// Whether any object changed.
bool Simulation::switch_objects(const EnableStep& step) {
    bool changed = false;
    for (std::size_t i = 0; i < campus_.objects.size(); ++i) {
        const std::string& id = campus_.objects[i].id;
        const bool meant = std::ranges::any_of(
            step.objects, [&](const auto& pattern) { return scene::glob_matches(pattern.glob, id); });
        if (meant && disabled_[i] == step.enabled) {
            disabled_[i] = !step.enabled;
            changed = true;
            add(step.enabled ? EventKind::object_enable : EventKind::object_disable, id).fields = {
                {"pos", avatar_.position}};
        }
    }
    return changed;
}

/// A solid that appears where the avatar is pushes it aside.
void Simulation::make_room(const EnableStep& step) {
    const double radius = walk_.avatar.radius;
    const auto solid =
        collision::obstruction(campus_.world, solids_, body_.foot, radius, mover_.height(), counters_);
    if (!solid) {
        return;
    }
    if (!collision::standing_place(campus_.world, solids_, body_.foot, radius, mover_.height(),
                                   kPlacementSearch, counters_)) {
        end_walk(step.mark, "enclosed",
                 campus_.objects[index_of(*solid)].id + " encloses the avatar; move it away before 'enable'");
        return;
    }
    set_down(body_.foot, walk_.name);
    avatar_.position = body_.foot;
    avatar_.vertical_speed = body_.vertical_speed;
    avatar_.grounded = body_.grounded;
}

void Simulation::report_push() {
    if (push_) {
        add(EventKind::avatar_depenetrated, push_->label).fields = {
            {"pos", body_.foot},
            {"from", push_->from},
            {"distance", Decimal{push_->distance, 3}},
            {"by", campus_.objects[index_of(push_->out_of)].id}};
        push_.reset();
    }
}

}  // namespace campuswalk::engine
