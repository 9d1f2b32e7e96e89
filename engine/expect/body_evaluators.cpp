#include "engine/expect/body_evaluators.h"

#include <algorithm>

#include "collision/world/placement.h"
#include "engine/events/decimals.h"
#include "engine/script/avatar_body.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

/// What an event says was in the way; empty when it couldn't tell.
std::string obstacle_of(const Event& event) {
    for (const Field& field : event.fields) {
        if (const auto* name = std::get_if<std::string>(&field.value);
            name != nullptr && field.name == "by") {
            return *name;
        }
    }
    return "";
}

std::string by(const std::string& object) {
    return object.empty() ? "" : "by " + object + " ";
}

}  // namespace

// ---- no_penetration -------------------------------------------------------------------------------------

NoPenetrationEvaluator::NoPenetrationEvaluator(const ExpectNoPenetration& expected,
                                               const scene::Campus& campus, const AvatarProfile& avatar)
    : expected_(&expected),
      campus_(&campus),
      avatar_(&avatar),
      ignored_layers_(ignored_layers(campus, avatar)) {}

void NoPenetrationEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    const double radius = avatar_->radius;
    const double height = record.avatar.stature * avatar_->height;
    const Vector3d& foot = record.avatar.position;
    const collision::Segment axis{foot + Vector3d(0, radius, 0), foot + Vector3d(0, height - radius, 0)};
    const collision::QueryFilter filter{collision::Detection::solid, ignored_layers_, record.disabled};
    collision::gather_obstacles(campus_->world, filter, axis, radius, pieces_);
    for (const collision::Obstacle& piece : pieces_) {
        see_depth(piece.object, radius - collision::closest(axis, piece).distance, now);
    }
    // Deep inside a closed mesh its surface may be out of reach.
    const Vector3d middle = 0.5 * (axis.a + axis.b);
    collision::Aabb box;
    box.extend(middle);
    campus_->world.candidates(box, filter, around_);
    for (const collision::ObjectId id : around_) {
        if (deepest_ < radius && collision::contains(campus_->world.object(id), middle)) {
            see_depth(id, radius, now);
        }
    }
}

void NoPenetrationEvaluator::see_depth(collision::ObjectId object, double depth, const StateSnapshot& now) {
    if (depth > deepest_) {
        deepest_ = depth;
        inside_ = index_of(object);
        when_ = now;
    }
}

Finding NoPenetrationEvaluator::finding(bool /*ended*/) const {
    constexpr double kMillimetres = 1000.0;
    if (!inside_) {
        return {true, expected_->mark, "the body was inside nothing", std::nullopt, true};
    }
    const bool met = deepest_ <= expected_->tolerance;
    return {met, expected_->mark,
            "the body was " + fixed(deepest_ * kMillimetres, 2) + " mm inside " +
                campus_->objects[*inside_].id + " " + at_time(when_->time) +
                (met ? "" : ", expected at most " + fixed(expected_->tolerance * kMillimetres, 2) + " mm"),
            when_, met};
}

// ---- grounded -------------------------------------------------------------------------------------------

void GroundedEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    if (record.tick == last_) {
        return;
    }
    last_ = record.tick;
    ++ticks_;
    if (!record.avatar.grounded) {
        ++airborne_;
        if (!first_) {
            first_ = now;
        }
    }
}

Finding GroundedEvaluator::finding(bool /*ended*/) const {
    if (airborne_ == 0) {
        return {true, expected_->mark, "the avatar was on the ground all the time", std::nullopt, true};
    }
    const double most = (1.0 - expected_->ratio) * static_cast<double>(ticks_);
    const bool met = static_cast<double>(airborne_) <= most + 1e-9;
    const bool always = expected_->ratio >= 1.0;
    return {
        met, expected_->mark,
        "the avatar was off the ground in " + std::to_string(airborne_) + " of " + std::to_string(ticks_) +
            " ticks, first " + at_time(first_->time) +
            (met ? "" : ", expected at most " + fixed(100.0 * (1.0 - expected_->ratio), 1) + " % of them"),
        first_, !always};
}

// ---- blocked_by -----------------------------------------------------------------------------------------

void BlockedByEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    for (const Event& event : record.events) {
        if (event.kind != EventKind::avatar_blocked && event.kind != EventKind::avatar_stuck) {
            continue;
        }
        const std::string object = obstacle_of(event);
        const bool meant = !object.empty() && scene::glob_matches(expected_->object.glob, object);
        if (meant && first_.empty()) {
            first_ = "the avatar was blocked " + by(object) + at_time(record.time);
            when_ = now;
        } else if (!meant) {
            other_ = "blocked " + by(object) + at_time(record.time);
        }
    }
}

Finding BlockedByEvaluator::finding(bool /*ended*/) const {
    if (!first_.empty()) {
        return {true, expected_->mark, first_, when_};
    }
    return {false, expected_->mark,
            "the avatar was never blocked by '" + expected_->object.glob + "'" +
                (other_.empty() ? "" : ", but " + other_),
            std::nullopt, true};
}

// ---- stuck ----------------------------------------------------------------------------------------------

void StuckEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    for (const Event& event : record.events) {
        if (event.kind != EventKind::avatar_stuck) {
            continue;
        }
        const std::string object = obstacle_of(event);
        const bool meant =
            expected_->by.glob == "*" || (!object.empty() && scene::glob_matches(expected_->by.glob, object));
        if (meant && first_.empty()) {
            first_ = "the avatar was stuck " + by(object) + at_time(record.time);
            when_ = now;
        } else if (!meant) {
            other_ = "stuck " + by(object) + at_time(record.time);
        }
    }
}

Finding StuckEvaluator::finding(bool /*ended*/) const {
    if (!first_.empty()) {
        return {true, expected_->mark, first_, when_};
    }
    return {false, expected_->mark,
            "the avatar was never stuck" +
                (expected_->by.glob == "*" ? "" : " by '" + expected_->by.glob + "'") +
                (other_.empty() ? "" : ", but " + other_),
            std::nullopt, true};
}

// ---- fell -----------------------------------------------------------------------------------------------

void FellEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    const bool falls = std::ranges::any_of(
        record.events, [](const Event& event) { return event.kind == EventKind::avatar_fell; });
    if (falls && !when_) {
        when_ = now;
    }
}

Finding FellEvaluator::finding(bool /*ended*/) const {
    if (when_) {
        return {true, expected_->mark, "the avatar fell off the world " + at_time(when_->time), when_};
    }
    return {false, expected_->mark, "the avatar did not fall off the world", std::nullopt, true};
}

}  // namespace campuswalk::engine
