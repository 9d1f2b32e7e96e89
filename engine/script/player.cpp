#include "engine/script/player.h"

#include <algorithm>

#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

ScriptPlayer::ScriptPlayer(const Walk& walk, RoutePlanner* routes)
    : walk_(walk), routes_(routes), dt_(1.0 / walk.sim.ticks_per_second) {
    begin_step();
}

Intent ScriptPlayer::intend(const AvatarState& avatar) {
    Intent intent;
    intent.yaw = avatar.yaw;
    intent.pitch = avatar.pitch;
    if (!finished()) {
        intend_step(avatar, intent);
    }
    return intent;
}

void ScriptPlayer::on_events(std::span<const Event> events) {
    auto* wait = finished() ? nullptr : std::get_if<Playing<WaitUntilStep>>(&*playing_);
    if (wait != nullptr) {
        wait->event_came |=
            std::ranges::any_of(events, [&](const Event& event) { return matches(wait->step.event, event); });
    }
}

std::optional<StepEnd> ScriptPlayer::settle(const AvatarState& avatar, std::vector<const Step*>& instant) {
    std::optional<StepEnd> end = finished() ? std::nullopt : end_of_step(avatar);
    if (!end) {
        return std::nullopt;
    }
    ++current_;
    for (; !end->fatal && !finished() && is_instant(walk_.steps[current_]); ++current_) {
        if (const auto* speed = std::get_if<SpeedStep>(&walk_.steps[current_])) {
            speed_ = speed->speed;
        } else {
            instant.push_back(&walk_.steps[current_]);
        }
    }
    begin_step();
    return end->kind || end->fatal ? end : std::nullopt;
}

const SourceMark* ScriptPlayer::mark() const {
    return finished() ? nullptr : &mark_of(walk_.steps[current_]);
}

}  // namespace campuswalk::engine
