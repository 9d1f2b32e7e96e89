#include "engine/expect/path_evaluators.h"

#include "engine/events/decimals.h"
#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

double distance_between(const Target& target, const Vector3d& position) {
    Vector3d way = target.point - position;
    if (!target.has_height) {
        way.y() = 0.0;
    }
    return way.norm();
}

/// Contacts tell where in the tick they came; other events are about its end.
Vector3d place_of(const Event& event, const Vector3d& end) {
    for (const Field& field : event.fields) {
        if (const auto* position = std::get_if<Vector3d>(&field.value);
            position != nullptr && field.name == "pos") {
            return *position;
        }
    }
    return end;
}

std::string metres(double value) {
    return fixed(value, 3) + " m";
}

}  // namespace

// ---- reaches --------------------------------------------------------------------------------------------

void ReachesEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    const double distance = distance_between(expected_->target, record.avatar.position);
    if (distance < nearest_) {
        nearest_ = distance;
        when_ = now;
    }
}

Finding ReachesEvaluator::finding(bool /*ended*/) const {
    const bool met = nearest_ <= expected_->within;
    const std::string came = "the avatar came within " + metres(nearest_) + " " + at_time(when_.time);
    return {met, expected_->mark,
            expected_->target.label +
                (met ? " was reached: " + came
                     : " was not reached: " + came + ", expected " + metres(expected_->within)),
            when_, !met};
}

// ---- near -----------------------------------------------------------------------------------------------

void NearEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    const Vector3d& end = record.avatar.position;
    if (!expected_->at) {
        last_ = Place{distance_between(expected_->target, end), at_time(record.time), now};
        return;
    }
    for (const Event& event : record.events) {
        if (!matches(*expected_->at, event)) {
            continue;
        }
        last_ = Place{distance_between(expected_->target, place_of(event, end)),
                      "at " + told(event, record.time), now};
        if (last_->distance > expected_->within && !first_) {
            first_ = last_;
        }
    }
}

std::string NearEvaluator::told_place(const Place& place) const {
    return "the avatar was " + metres(place.distance) + " from " + expected_->target.label + " " + place.when;
}

Finding NearEvaluator::finding(bool /*ended*/) const {
    if (!last_) {
        const EventPattern& at = expected_->at.value_or(EventPattern{});
        return {false, at.mark,
                "'" + told(at) + "' never came, so nothing was near " + expected_->target.label, std::nullopt,
                true};
    }
    const Place& place = first_ ? *first_ : *last_;
    const bool met = place.distance <= expected_->within;
    return {met, expected_->mark,
            told_place(place) + (met ? "" : ", expected within " + metres(expected_->within)), place.moment,
            !first_};
}

// ---- duration and distance ------------------------------------------------------------------------------

Finding DurationEvaluator::finding(bool ended) const {
    const std::string wanted = broken_limit(expected_->seconds, time_, " s");
    return {wanted.empty(), expected_->mark,
            (ended ? "the walk took " : "the walk had taken ") + fixed(time_, 3) + " s" +
                (wanted.empty() ? "" : ", expected " + wanted),
            std::nullopt, still_open(expected_->seconds, time_)};
}

Finding DistanceEvaluator::finding(bool ended) const {
    const std::string wanted = broken_limit(expected_->metres, distance_, " m");
    return {wanted.empty(), expected_->mark,
            (ended ? "the avatar went " : "the avatar had gone ") + metres(distance_) +
                (wanted.empty() ? "" : ", expected " + wanted),
            std::nullopt, still_open(expected_->metres, distance_)};
}

}  // namespace campuswalk::engine
