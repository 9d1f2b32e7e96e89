#include "engine/events/event.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

const std::vector<std::pair<EventKind, std::string>> kExpected = {
    {EventKind::walk_start, "walk.start"},
    {EventKind::walk_end, "walk.end"},
    {EventKind::avatar_spawn, "avatar.spawn"},
    {EventKind::avatar_teleport, "avatar.teleport"},
    {EventKind::avatar_arrive, "avatar.arrive"},
    {EventKind::avatar_blocked, "avatar.blocked"},
    {EventKind::avatar_landed, "avatar.landed"},
    {EventKind::avatar_fell, "avatar.fell"},
    {EventKind::avatar_jump, "avatar.jump"},
    {EventKind::avatar_crouch, "avatar.crouch"},
    {EventKind::avatar_stand, "avatar.stand"},
    {EventKind::avatar_stuck, "avatar.stuck"},
    {EventKind::avatar_depenetrated, "avatar.depenetrated"},
    {EventKind::object_enable, "object.enable"},
    {EventKind::object_disable, "object.disable"},
    {EventKind::collision_enter, "collision.enter"},
    {EventKind::collision_stay, "collision.stay"},
    {EventKind::collision_exit, "collision.exit"},
    {EventKind::trigger_enter, "trigger.enter"},
    {EventKind::trigger_stay, "trigger.stay"},
    {EventKind::trigger_exit, "trigger.exit"},
    {EventKind::ray_enter, "ray.enter"},
    {EventKind::ray_stay, "ray.stay"},
    {EventKind::ray_exit, "ray.exit"},
    {EventKind::popup_open, "popup.open"},
    {EventKind::popup_close, "popup.close"},
    {EventKind::snapshot_take, "snapshot.take"},
    {EventKind::expect_fail, "expect.fail"},
};

TEST(EventKind, HasTheExpectedName) {
    for (const auto& [kind, name] : kExpected) {
        EXPECT_EQ(name_of(kind), name);
    }
}

TEST(EventKind, NamesAreInTheOrderOfTheEnum) {
    const std::vector<EventKind> kinds = event_kinds();
    ASSERT_EQ(kinds.size(), static_cast<std::size_t>(EventKind::expect_fail) + 1)
        << "does a kind lack a name?";
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(kinds[i], static_cast<EventKind>(i));
        EXPECT_EQ(name_of(kinds[i]), kExpected[i].second);
        names.insert(name_of(kinds[i]));
    }
    EXPECT_EQ(names.size(), kinds.size());
}

}  // namespace
}  // namespace campuswalk::engine
