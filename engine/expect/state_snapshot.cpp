#include "engine/expect/state_snapshot.h"

#include <algorithm>

namespace campuswalk::engine {

void StateHistory::on_tick(const TickRecord& record) {
    now_.tick = record.tick;
    now_.time = record.time;
    now_.avatar = record.avatar;
    now_.distance = record.distance;
    now_.building.reset();
    if (!record.open_popups.empty()) {
        now_.building = record.open_popups.back().building;
    }
    for (const Event& event : record.events) {
        keep(event, record.time);
        const bool switched =
            event.kind == EventKind::object_enable || event.kind == EventKind::object_disable;
        if (switched && record.disabled != nullptr) {
            now_.disabled = std::make_shared<const std::vector<bool>>(*record.disabled);
        }
    }
}

void StateHistory::keep(const Event& event, double time) {
    std::rotate(now_.events.begin(), now_.events.begin() + 1, now_.events.end());
    now_.events.back() = std::make_shared<const TimedEvent>(TimedEvent{event, time});
    if (event.kind == EventKind::avatar_blocked || event.kind == EventKind::avatar_stuck) {
        now_.obstacle = now_.events.back();
    }
}

}  // namespace campuswalk::engine
