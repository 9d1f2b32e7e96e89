#include "engine/simulation/contact_detector.h"

#include <algorithm>
#include <tuple>

#include "collision/geometry/trigonometry.h"
#include "collision/world/cast.h"
#include "collision/world/overlap_span.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::Detection;
using collision::QueryFilter;
using collision::Ray;
using collision::Segment;
using collision::Vec3;

namespace {

// Contact begins a little inside the distance at which it ends, so that resting at it doesn't flicker.
constexpr double kTouchSlack = 1e-3;   // metres beyond the skin: bumping into something begins
constexpr double kPartSlack = 5e-3;    // metres beyond the skin: and ends
constexpr double kVolumeSlack = 1e-3;  // metres outside a trigger at which it is left

void sort_for_log(std::vector<SensedTransition>& transitions) {
    std::ranges::sort(transitions, {}, [](const SensedTransition& s) {
        return std::tuple(s.transition.at, s.transition.phase, s.transition.object, s.strategy);
    });
}

}  // namespace

Senses::Senses(const scene::Campus& campus, const AvatarProfile& avatar, std::uint32_t ignored_layers,
               Tick stay_ticks, Tick gaze_hold, const std::vector<bool>* disabled)
    : campus_(campus),
      avatar_(avatar),
      ignored_layers_(ignored_layers),
      disabled_(disabled),
      solids_(stay_ticks),
      triggers_(stay_ticks),
      gaze_(stay_ticks),
      gaze_memory_(gaze_hold) {}

void Senses::sense(Tick tick, const AvatarState& avatar, const collision::MoveTrace& trace,
                   std::vector<SensedTransition>& out, collision::QueryCounters& counters) {
    out.clear();
    see_solids(trace);
    collect(tick, Strategy::collision, solids_, out);
    see_triggers(avatar.stature * avatar_.height, trace, counters);
    collect(tick, Strategy::trigger, triggers_, out);
    see_gaze(tick, avatar, counters);
    collect(tick, Strategy::ray, gaze_, out);
    sort_for_log(out);
}

void Senses::sense_again(Tick tick, const AvatarState& avatar, const collision::MoveTrace& trace,
                         std::vector<SensedTransition>& out, collision::QueryCounters& counters) {
    if (disabled_ != nullptr) {
        for (std::size_t i = 0; i < disabled_->size(); ++i) {
            if ((*disabled_)[i]) {
                gaze_memory_.forget(static_cast<collision::ObjectId>(i));
            }
        }
    }
    sense(tick, avatar, trace, out, counters);
    // `sense` has told this tick's stays before.
    std::erase_if(out, [](const SensedTransition& s) { return s.transition.phase == Phase::stay; });
}

void Senses::leave_all(Tick tick, std::vector<SensedTransition>& out) {
    out.clear();
    const auto leave = [&](Strategy strategy, ContactTracker& tracker) {
        changes_.clear();
        tracker.leave_all(tick, changes_);
        for (const Transition& t : changes_) {
            out.push_back({strategy, t, 0.0});
        }
    };
    leave(Strategy::collision, solids_);
    leave(Strategy::trigger, triggers_);
    leave(Strategy::ray, gaze_);
    gaze_memory_.forget_all();
    sort_for_log(out);
}

void Senses::collect(Tick tick, Strategy strategy, ContactTracker& tracker,
                     std::vector<SensedTransition>& out) {
    changes_.clear();
    tracker.update(tick, seen_, changes_);
    for (const Transition& t : changes_) {
        out.push_back({strategy, t, strategy == Strategy::ray ? gaze_memory_.distance(t.object) : 0.0});
    }
}

void Senses::see_solids(const collision::MoveTrace& trace) {
    seen_.clear();
    for (const collision::Touch& touch : trace.touching) {
        const double slack = solids_.active(touch.object) ? kPartSlack : kTouchSlack;
        if (touch.gap <= avatar_.skin_width + slack) {
            seen_.push_back({touch.object});
        }
    }
}

void Senses::see_triggers(double height, const collision::MoveTrace& trace,
                          collision::QueryCounters& counters) {
    seen_.clear();
    Aabb box;
    for (const Vec3& foot : trace.path) {
        box.extend(foot);
        box.extend(foot + Vec3(0, height, 0));
    }
    const QueryFilter filter{Detection::trigger, ignored_layers_, disabled_};
    campus_.world.candidates(box.grown(avatar_.radius + kVolumeSlack), filter, candidates_);
    for (const collision::ObjectId id : candidates_) {
        const Sighting sighting = sight_trigger(id, height, trace.path, counters);
        if (sighting.met || triggers_.active(id)) {
            seen_.push_back(sighting);
        }
    }
}

/// How the avatar meets a volume along its path, from the first contact to the last.
Sighting Senses::sight_trigger(collision::ObjectId id, double height, const std::vector<Vec3>& path,
                               collision::QueryCounters& counters) const {
    const double radius = avatar_.radius + (triggers_.active(id) ? kVolumeSlack : 0.0);
    const auto span_from = [&](const Vec3& foot, const Vec3& move) {
        const Segment body{foot + Vec3(0, avatar_.radius, 0), foot + Vec3(0, height - avatar_.radius, 0)};
        return overlap_span(campus_.world, id, body, radius, move, counters);
    };
    if (path.size() == 1) {  // put down here
        const bool inside = span_from(path.front(), Vec3::Zero()).has_value();
        return {id, inside, inside, 1.0, 1.0};
    }
    Sighting sighting{id, false, false, 1.0, 0.0};
    const auto parts = static_cast<double>(path.size() - 1);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const auto span = span_from(path[i], path[i + 1] - path[i]);
        sighting.present = span && span->at_end;
        if (span) {
            const auto part = static_cast<double>(i);
            sighting.enter_at = sighting.met ? sighting.enter_at : (part + span->enter) / parts;
            sighting.exit_at = (part + span->leave) / parts;
            sighting.met = true;
        }
    }
    return sighting;
}

void Senses::see_gaze(Tick tick, const AvatarState& avatar, collision::QueryCounters& counters) {
    seen_.clear();
    const auto [sin_yaw, cos_yaw] = collision::sin_cos(avatar.yaw);
    const auto [sin_pitch, cos_pitch] = collision::sin_cos(avatar.pitch);
    const Vec3 direction(-sin_yaw * cos_pitch, sin_pitch, -cos_yaw * cos_pitch);
    const Vec3 eye = avatar.position + Vec3(0, avatar.stature * avatar_.eye_height, 0);
    const Ray ray{eye, eye + avatar_.look_distance * direction};
    const QueryFilter filter{Detection::solid | Detection::ray, ignored_layers_, disabled_};
    const auto hit = collision::cast(campus_.world, filter, ray, Detection::ray, counters);
    if (hit && any_of(campus_.world.object(hit->object).detection, Detection::ray)) {
        gaze_memory_.meet(tick, hit->object, hit->fraction * avatar_.look_distance);
    }
    gaze_memory_.advance(tick);
    for (const GazeMemory::Look& look : gaze_memory_.looks()) {
        seen_.push_back({look.object});
    }
}

}  // namespace campuswalk::engine
