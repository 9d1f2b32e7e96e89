#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "engine/events/reason.h"

namespace campuswalk::engine {

using Tick = std::int64_t;

enum class EventKind : std::uint8_t {
    walk_start,
    walk_end,
    avatar_spawn,
    avatar_teleport,
    avatar_arrive,   ///< a walk_to reached its target
    avatar_blocked,  ///< a walk_to gave up
    avatar_landed,   ///< on the ground again after a fall, with its height
    avatar_fell,     ///< below everything
    avatar_jump,
    avatar_crouch,
    avatar_stand,         ///< up from crouching
    avatar_stuck,         ///< tries to move but makes no progress
    avatar_depenetrated,  ///< placed inside something and pushed out of it
    object_enable,
    object_disable,
    collision_enter,
    collision_stay,
    collision_exit,
    trigger_enter,
    trigger_stay,
    trigger_exit,
    ray_enter,
    ray_stay,
    ray_exit,
    popup_open,
    popup_close,
    snapshot_take,
    expect_fail,
};

/// The name in logs and patterns, e.g. "collision.enter".
std::string_view name_of(EventKind kind);
/// All of them, in their order.
std::vector<EventKind> event_kinds();

/// A number that logs print with a fixed number of decimals.
struct Decimal {
    double value = 0.0;
    int digits = 3;
};

/// Free text, printed in quotes; a plain string is a name and printed without.
struct Text {
    std::string value;
};

/// Positions are printed with three decimals, a reason as the text that words it. Reasons are large and rare:
/// they are shared.
using FieldValue =
    std::variant<std::int64_t, Decimal, Eigen::Vector3d, std::string, Text, std::shared_ptr<const Reason>>;

/// A named detail of an event, printed `name=value` in text and as a member in JSON, in this order.
struct Field {
    std::string_view name;
    FieldValue value;
};

/// Something that happened. The order within a tick is total: if the avatar is put elsewhere, first the
/// contacts that this ends; then the start of the walk, spawn, teleport and jump; then contacts by (at, exits
/// before enters before stays, object, detection mode), each pop-up next to its contact, and after them the
/// pop-ups whose dwell time is over; then landing, falling out of the world, being stuck and the end of a
/// step; last the instant steps, in the script's order, each with the contacts that it ends or begins.
///
/// An enter or exit that isn't due to the avatar's motion has a `cause`: spawn, teleport, enable, disabled or
/// end (of the walk). Every enter has its exit.
struct Event {
    Tick tick = 0;
    double at = 1.0;  ///< fraction of the tick at which it happened, [0, 1]
    EventKind kind = EventKind::walk_start;
    std::string object;
    std::vector<Field> fields;
};

/// The field that explains an event, a Reason. It isn't hashed: what a walk did is the same with and without
/// it.
inline constexpr std::string_view kWhy = "why";

/// The value of a field; null if the event has none of that name and type.
template <typename Value>
const Value* find_field(const Event& event, std::string_view name) {
    const auto field = std::ranges::find(event.fields, name, &Field::name);
    return field == event.fields.end() ? nullptr : std::get_if<Value>(&field->value);
}

/// The reason that explains it; null if it has none.
inline const Reason* reason_of(const Event& event) {
    const auto* why = find_field<std::shared_ptr<const Reason>>(event, kWhy);
    return why != nullptr ? why->get() : nullptr;
}

/// The events of one tick, in log order.
struct TickEvents {
    Tick tick = 0;
    std::vector<Event> list;

    void begin(Tick next) {
        tick = next;
        list.clear();
    }
    Event& add(EventKind kind, std::string object, std::vector<Field> fields = {}, double at = 1.0) {
        return list.emplace_back(Event{tick, at, kind, std::move(object), std::move(fields)});
    }
};

}  // namespace campuswalk::engine
