#include "engine/simulation/contact_detector.h"

#include <algorithm>
#include <tuple>

#include "collision/geometry/trigonometry.h"
#include "collision/world/cast.h"
#include "collision/world/overlap_span.h"
#include "engine/script/avatar_body.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::Detection;
using collision::QueryFilter;
using collision::Ray;
using collision::Segment;
using collision::Vec3;

namespace {

// A contact begins a little closer than it ends, so that it doesn't flicker at rest.
constexpr double kExitSlack = 5e-3;    // metres beyond the skin: it ends
constexpr double kVolumeSlack = 1e-3;  // metres outside a trigger: its overlap ends

void sort_for_log(std::vector<DetectedTransition>& transitions) {
    std::ranges::sort(transitions, {}, [](const DetectedTransition& s) {
        return std::tuple(s.transition.at, s.transition.phase, s.transition.object, s.mode);
    });
}

}  // namespace

ContactDetector::ContactDetector(const scene::Campus& campus, const AvatarProfile& avatar,
                                 std::uint32_t ignored_layers, Tick stay_ticks, Tick gaze_hold,
                                 const std::vector<bool>* disabled)
    : campus_(campus),
      avatar_(avatar),
      ignored_layers_(ignored_layers),
      disabled_(disabled),
      solids_(stay_ticks),
      triggers_(stay_ticks),
      gaze_(stay_ticks),
      gaze_tracker_(gaze_hold) {}

void ContactDetector::detect(Tick tick, const AvatarState& avatar, const collision::MoveTrace& trace,
                             std::vector<DetectedTransition>& out, collision::QueryStatistics* statistics) {
    out.clear();
    find_solid_contacts(trace);
    collect(tick, DetectionMode::solid, solids_, out);
    find_trigger_overlaps(avatar.stature * avatar_.height, trace, statistics);
    collect(tick, DetectionMode::trigger, triggers_, out);
    find_gaze_hits(tick, avatar, statistics);
    collect(tick, DetectionMode::ray, gaze_, out);
    sort_for_log(out);
}

void ContactDetector::detect_again(Tick tick, const AvatarState& avatar, const collision::MoveTrace& trace,
                                   std::vector<DetectedTransition>& out,
                                   collision::QueryStatistics* statistics) {
    if (disabled_ != nullptr) {
        for (std::size_t i = 0; i < disabled_->size(); ++i) {
            if ((*disabled_)[i]) {
                gaze_tracker_.forget(static_cast<collision::ObjectId>(i));
            }
        }
    }
    detect(tick, avatar, trace, out, statistics);
    // `detect` has already reported this tick's stays.
    std::erase_if(out, [](const DetectedTransition& s) { return s.transition.phase == Phase::stay; });
}

void ContactDetector::leave_all(Tick tick, std::vector<DetectedTransition>& out) {
    out.clear();
    const auto leave = [&](DetectionMode mode, ContactTracker& tracker) {
        changes_.clear();
        tracker.leave_all(tick, changes_);
        for (const Transition& t : changes_) {
            out.push_back({mode, t, 0.0});
        }
    };
    leave(DetectionMode::solid, solids_);
    leave(DetectionMode::trigger, triggers_);
    leave(DetectionMode::ray, gaze_);
    gaze_tracker_.forget_all();
    sort_for_log(out);
}

void ContactDetector::collect(Tick tick, DetectionMode mode, ContactTracker& tracker,
                              std::vector<DetectedTransition>& out) {
    changes_.clear();
    tracker.update(tick, seen_, changes_);
    for (const Transition& t : changes_) {
        out.push_back({mode, t, mode == DetectionMode::ray ? gaze_tracker_.distance(t.object) : 0.0});
    }
}

void ContactDetector::find_solid_contacts(const collision::MoveTrace& trace) {
    seen_.clear();
    for (const collision::Touch& touch : trace.touching) {
        const double slack = solids_.active(touch.object) ? kExitSlack : kTouchSlack;
        if (touch.gap <= avatar_.skin_width + slack) {
            seen_.push_back({touch.object});
        }
    }
}

void ContactDetector::find_trigger_overlaps(double height, const collision::MoveTrace& trace,
                                            collision::QueryStatistics* statistics) {
    seen_.clear();
    Aabb box;
    for (const Vec3& foot : trace.path) {
        box.extend(foot);
        box.extend(foot + Vec3(0, height, 0));
    }
    const QueryFilter filter{Detection::trigger, ignored_layers_, disabled_};
    campus_.world.candidates(box.grown(avatar_.radius + kVolumeSlack), filter, candidates_);
    for (const collision::ObjectId id : candidates_) {
        const ObjectOverlap overlap = trigger_overlap(id, height, trace.path, statistics);
        if (overlap.touched || triggers_.active(id)) {
            seen_.push_back(overlap);
        }
    }
}

/// How the avatar overlaps a volume along its path: from the first overlap to the end of the last.
ObjectOverlap ContactDetector::trigger_overlap(collision::ObjectId id, double height,
                                               const std::vector<Vec3>& path,
                                               collision::QueryStatistics* statistics) const {
    const double radius = avatar_.radius + (triggers_.active(id) ? kVolumeSlack : 0.0);
    const auto span_from = [&](const Vec3& foot, const Vec3& move) {
        const Segment body = collision::upright_axis(foot, avatar_.radius, height);
        return overlap_span(campus_.world, id, body, radius, move, statistics);
    };
    if (path.size() == 1) {  // placed here
        const bool inside = span_from(path.front(), Vec3::Zero()).has_value();
        return {id, inside, inside, 1.0, 1.0};
    }
    ObjectOverlap overlap{id, false, false, 1.0, 0.0};
    const auto parts = static_cast<double>(path.size() - 1);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const auto span = span_from(path[i], path[i + 1] - path[i]);
        overlap.present = span && span->at_end;
        if (span) {
            const auto part = static_cast<double>(i);
            overlap.enter_at = overlap.touched ? overlap.enter_at : (part + span->enter) / parts;
            overlap.exit_at = (part + span->leave) / parts;
            overlap.touched = true;
        }
    }
    return overlap;
}

void ContactDetector::find_gaze_hits(Tick tick, const AvatarState& avatar,
                                     collision::QueryStatistics* statistics) {
    seen_.clear();
    const auto [sin_yaw, cos_yaw] = collision::sin_cos(avatar.yaw);
    const auto [sin_pitch, cos_pitch] = collision::sin_cos(avatar.pitch);
    const Vec3 direction(-sin_yaw * cos_pitch, sin_pitch, -cos_yaw * cos_pitch);
    const Vec3 eye = avatar.position + Vec3(0, avatar.stature * avatar_.eye_height, 0);
    const Ray ray{eye, eye + avatar_.look_distance * direction};
    const QueryFilter filter{Detection::solid | Detection::ray, ignored_layers_, disabled_};
    const auto hit = collision::cast(campus_.world, filter, ray, Detection::ray, statistics);
    if (hit && any_of(campus_.world.object(hit->object).detection, Detection::ray)) {
        gaze_tracker_.hit(tick, hit->object, hit->fraction * avatar_.look_distance);
    }
    gaze_tracker_.advance(tick);
    for (const GazeTracker::Look& look : gaze_tracker_.looks()) {
        seen_.push_back({look.object});
    }
}

}  // namespace campuswalk::engine
