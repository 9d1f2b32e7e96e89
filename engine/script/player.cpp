#include "engine/script/player.h"

#include <algorithm>

#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

ScriptPlayer::ScriptPlayer(const Walk& walk, RoutePlanner* routes)
    : walk_(walk), routes_(routes), dt_(1.0 / walk.sim.ticks_per_second) {}

Intent ScriptPlayer::intend(const AvatarState& avatar) {
    Intent intent;
    intent.yaw = avatar.yaw;
    intent.pitch = avatar.pitch;
    if (!finished()) {
        intend_step(avatar, intent);
        ++progress_.ticks;
    }
    return intent;
}

void ScriptPlayer::on_events(std::span<const Event> events) {
    if (finished()) {
        return;
    }
    if (const auto* wait = std::get_if<WaitUntilStep>(&walk_.steps[current_])) {
        progress_.awaited_event_came |=
            std::ranges::any_of(events, [&](const Event& event) { return matches(wait->event, event); });
    }
}

std::optional<StepEnd> ScriptPlayer::settle(const AvatarState& avatar, std::vector<const Step*>& instant) {
    std::optional<StepEnd> end = finished() ? std::nullopt : end_of_step(avatar);
    if (!end) {
        return std::nullopt;
    }
    progress_ = {};
    ++current_;
    if (end->fatal) {
        return end;
    }
    for (; !finished() && is_instant(walk_.steps[current_]); ++current_) {
        if (const auto* speed = std::get_if<SpeedStep>(&walk_.steps[current_])) {
            speed_ = speed->speed;
        } else {
            instant.push_back(&walk_.steps[current_]);
        }
    }
    return end->kind ? end : std::nullopt;
}

const SourceMark* ScriptPlayer::mark() const {
    return finished() ? nullptr : &mark_of(walk_.steps[current_]);
}

}  // namespace campuswalk::engine
