#include "engine/events/event.h"

#include <array>
#include <cassert>

namespace campuswalk::engine {

namespace {

// In the order of EventKind.
constexpr std::array kNames = {
    std::pair{EventKind::walk_start, "walk.start"},
    std::pair{EventKind::walk_end, "walk.end"},
    std::pair{EventKind::avatar_spawn, "avatar.spawn"},
    std::pair{EventKind::avatar_teleport, "avatar.teleport"},
    std::pair{EventKind::avatar_arrive, "avatar.arrive"},
    std::pair{EventKind::avatar_blocked, "avatar.blocked"},
    std::pair{EventKind::avatar_landed, "avatar.landed"},
    std::pair{EventKind::avatar_fell, "avatar.fell"},
    std::pair{EventKind::avatar_jump, "avatar.jump"},
    std::pair{EventKind::avatar_crouch, "avatar.crouch"},
    std::pair{EventKind::avatar_stand, "avatar.stand"},
    std::pair{EventKind::avatar_stuck, "avatar.stuck"},
    std::pair{EventKind::avatar_depenetrated, "avatar.depenetrated"},
    std::pair{EventKind::object_enable, "object.enable"},
    std::pair{EventKind::object_disable, "object.disable"},
    std::pair{EventKind::collision_enter, "collision.enter"},
    std::pair{EventKind::collision_stay, "collision.stay"},
    std::pair{EventKind::collision_exit, "collision.exit"},
    std::pair{EventKind::trigger_enter, "trigger.enter"},
    std::pair{EventKind::trigger_stay, "trigger.stay"},
    std::pair{EventKind::trigger_exit, "trigger.exit"},
    std::pair{EventKind::ray_enter, "ray.enter"},
    std::pair{EventKind::ray_stay, "ray.stay"},
    std::pair{EventKind::ray_exit, "ray.exit"},
    std::pair{EventKind::popup_open, "popup.open"},
    std::pair{EventKind::popup_close, "popup.close"},
    std::pair{EventKind::snapshot_take, "snapshot.take"},
    std::pair{EventKind::expect_fail, "expect.fail"},
};

}  // namespace

std::string_view name_of(EventKind kind) {
    const auto& [named, name] = kNames[static_cast<std::size_t>(kind)];
    assert(named == kind);
    static_cast<void>(named);
    return name;
}

std::vector<EventKind> event_kinds() {
    std::vector<EventKind> kinds;
    kinds.reserve(kNames.size());
    for (const auto& [kind, name] : kNames) {
        kinds.push_back(kind);
    }
    return kinds;
}

}  // namespace campuswalk::engine
