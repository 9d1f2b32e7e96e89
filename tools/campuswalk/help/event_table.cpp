#include "tools/campuswalk/help/event_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace campuswalk::tools::help {

using engine::EventKind;

namespace {

constexpr const char* kWalkName = "the walk's name";
constexpr const char* kTarget = "the target";
constexpr const char* kTouched = "the object";
constexpr const char* kBuilding = "the building";

constexpr std::array kWithoutPosition = {EventKind::walk_end, EventKind::popup_open, EventKind::popup_close,
                                         EventKind::expect_fail};

std::vector<EventKind> with_position() {
    std::vector<EventKind> kinds;
    for (const EventDescription& event : event_descriptions()) {
        if (std::ranges::find(kWithoutPosition, event.kind) == kWithoutPosition.end()) {
            kinds.push_back(event.kind);
        }
    }
    return kinds;
}

std::string padded(std::string_view text, std::size_t width) {
    return std::string(text) + std::string(width - std::min(width, text.size()), ' ');
}

}  // namespace

std::vector<EventDescription> event_descriptions() {
    return {
        {EventKind::walk_start, kWalkName, "the walk has begun, with its first step"},
        {EventKind::walk_end, kWalkName, "the walk is over: the last line of every log"},
        {EventKind::avatar_spawn, "the spawn", "a program that uses the library has placed the avatar anew"},
        {EventKind::avatar_teleport, "where to",
         "a teleport has placed the avatar; before, all contacts end"},
        {EventKind::avatar_arrive, kTarget, "a walk_to, go_to or follow has got to its target"},
        {EventKind::avatar_blocked, kTarget, "a walk_to or follow has given up: something is in the way"},
        {EventKind::avatar_landed, kWalkName, "on the ground again, after a jump or a fall of 0.5 m or more"},
        {EventKind::avatar_fell, kWalkName, "it has fallen out of the world, which ends the walk"},
        {EventKind::avatar_jump, kWalkName, "a step made it jump"},
        {EventKind::avatar_crouch, kWalkName, "a step made it lower"},
        {EventKind::avatar_stand, kWalkName, "a step made it stand up"},
        {EventKind::avatar_stuck, kWalkName,
         "it tried to move for a second, and got less than 10 cm farther"},
        {EventKind::avatar_depenetrated, "where it was placed", "it was placed in an object and pushed out"},
        {EventKind::object_enable, kTouched, "a step switched the object on"},
        {EventKind::object_disable, kTouched, "a step switched the object off"},
        {EventKind::collision_enter, kTouched, "the body touches a solid object that it doesn't stand on"},
        {EventKind::collision_stay, kTouched, "the body still touches it: every second"},
        {EventKind::collision_exit, kTouched, "the body no longer touches it"},
        {EventKind::trigger_enter, kTouched, "the body has got into a trigger"},
        {EventKind::trigger_stay, kTouched, "the body is still in it: every second"},
        {EventKind::trigger_exit, kTouched, "the body has got out of it"},
        {EventKind::ray_enter, kTouched, "the visitor looks at the object, with nothing solid in between"},
        {EventKind::ray_stay, kTouched, "the visitor still looks at it: every second"},
        {EventKind::ray_exit, kTouched, "the visitor has looked elsewhere for 0.2 s"},
        {EventKind::popup_open, kBuilding, "a contact that opens it has begun, and lasted its dwell time"},
        {EventKind::popup_close, kBuilding, "the last of these contacts has ended"},
        {EventKind::snapshot_take, "the picture's name", "a snapshot step was reached"},
        {EventKind::expect_fail, "the failure's code", "an expectation or a step has failed"},
    };
}

std::vector<FieldDescription> field_descriptions() {
    using enum EventKind;
    return {
        {"pos", "three numbers",
         "The foot point, in metres; of contacts, where it was when the contact began or ended.",
         with_position()},
        {"yaw",
         "number",
         "Viewing direction in degrees: 0 looks along −Z, positive turns left.",
         {walk_start, avatar_spawn, avatar_teleport}},
        {"at",
         "number",
         "The fraction of the tick at which the body got in or out; not there if there is a `cause`.",
         {trigger_enter, trigger_exit}},
        {"distance",
         "number",
         "Of a gaze: from the eyes to the object. Of `avatar.depenetrated`: how far it was pushed. In "
         "metres.",
         {ray_enter, ray_stay, avatar_depenetrated}},
        {"ticks",
         "whole number",
         "For how many ticks the contact has lasted.",
         {collision_stay, collision_exit, trigger_stay, trigger_exit, ray_stay, ray_exit}},
        {"cause",
         "word",
         "Why a contact began or ended, if not by the avatar's motion: `spawn`, `teleport`, `enable`, "
         "`disabled`, or "
         "`end` of the walk.",
         {collision_enter, collision_exit, trigger_enter, trigger_exit, ray_enter, ray_exit}},
        {"title", "text", "The pop-up's first line.", {popup_open}},
        {"body", "text", "The pop-up's text.", {popup_open}},
        {"from", "three numbers", "Where it was placed, before it was pushed out.", {avatar_depenetrated}},
        {"height",
         "number",
         "How far it fell, or how tall it is now; in metres.",
         {avatar_landed, avatar_crouch, avatar_stand}},
        {"speed", "number", "Upwards at take-off, in metres per second.", {avatar_jump}},
        {"by",
         "word",
         "The object in the way, or out of which it was pushed.",
         {avatar_blocked, avatar_stuck, avatar_depenetrated}},
        {"why", "text", "The measured reason. It isn't part of the hash.", {avatar_blocked, avatar_stuck}},
        {"line", "whole number", "The line of the walk file with the expectation or step.", {expect_fail}},
        {"message", "text", "What happened instead.", {expect_fail}},
        {"file", "word", "The file with that line, if it isn't the walk itself.", {expect_fail}},
        {"result", "word", "`pass` or `fail`.", {walk_end}},
        {"events", "whole number", "Events between `walk.start` and `walk.end`.", {walk_end}},
        {"dist", "number", "Metres along the path of the foot point.", {walk_end}},
        {"hash",
         "16 digits",
         "Of the bits of every tick's position and of every event: equal hashes mean equal walks.",
         {walk_end}},
    };
}

std::string event_lines() {
    std::string lines;
    for (const EventDescription& event : event_descriptions()) {
        lines += "  " + padded(name_of(event.kind), 20) + "  " + padded(event.object, 19) + "  " +
                 std::string(event.when) + "\n";
    }
    return lines;
}

Json event_json() {
    const std::vector<FieldDescription> fields = field_descriptions();
    Json json = {{"campuswalk_events", 1}, {"events", Json::array()}, {"fields", Json::array()}};
    for (const EventDescription& event : event_descriptions()) {
        Json names = Json::array();
        for (const FieldDescription& field : fields) {
            if (std::ranges::find(field.events, event.kind) != field.events.end()) {
                names.push_back(field.name);
            }
        }
        json["events"].push_back({{"event", name_of(event.kind)},
                                  {"object", event.object},
                                  {"when", event.when},
                                  {"fields", std::move(names)}});
    }
    for (const FieldDescription& field : fields) {
        json["fields"].push_back({{"field", field.name}, {"value", field.value}, {"meaning", field.meaning}});
    }
    return json;
}

}  // namespace campuswalk::tools::help
