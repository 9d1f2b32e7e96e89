#include "engine/observers/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "collision/geometry/closest.h"
#include "engine/events/decimals.h"
#include "engine/events/event_text.h"
#include "engine/script/avatar_body.h"
#include "engine/script/step_text.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

constexpr double kTurn = 3600.0;         // tenths of a degree
constexpr double kMillimetres = 1000.0;  // a metre
constexpr std::array<const char*, PathSample::kSize + 1> kColumns = {"tick", "x", "y", "z", "yaw", "pitch"};

// A contact is searched for this far from the body, and rather above its feet than at the ground, metres.
constexpr double kReach = 0.1;
constexpr double kUnderfoot = 0.1;

/// As a JSON string has it, too.
bool is_plain(char c) {
    return c >= ' ' && c <= '~' && c != '"' && c != '\\';
}

/// Bytes that aren't UTF-8 can't be written in JSON: they become U+FFFD.
std::string json_text(const std::string& text) {
    if (std::ranges::all_of(text, is_plain)) {  // nearly all lines of logs
        return '"' + text + '"';
    }
    return scene::printable_json(
        nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string triple(const Vector3d& value) {
    return "[" + fixed(value) + "]";
}

std::string member(const char* name, double value) {
    return std::string(",\"") + name + "\":" + fixed(value, 3);
}

/// The lowest that a step of the walk makes the avatar.
std::optional<double> lowest_height(const Walk& walk) {
    double lowest = walk.avatar.height;
    for (const Step& step : walk.steps) {
        if (const auto* crouch = std::get_if<CrouchStep>(&step)) {
            lowest = std::min(lowest, crouch->height);
        }
    }
    return lowest < walk.avatar.height ? std::optional(lowest) : std::nullopt;
}

std::string json_of(const Walk& walk) {
    const AvatarProfile& avatar = walk.avatar;
    std::string text =
        "{\"campuswalk_recording\":1,\"ticks_per_second\":" + std::to_string(walk.sim.ticks_per_second) +
        ",\"campus\":{\"name\":" + json_text(walk.campus_name) +
        ",\"file\":" + json_text(walk.campus.lexically_normal().generic_string()) +
        "},\"avatar\":{\"radius\":" + fixed(avatar.radius, 3) + member("height", avatar.height) +
        member("eye_height", avatar.eye_height);
    if (const auto height = lowest_height(walk)) {
        text += member("crouch_height", *height) +
                member("crouch_eye_height", avatar.eye_height * *height / avatar.height);
    }
    return text + member("gaze_distance", avatar.look_distance) + "},\"log\":[";
}

/// Items, one per line, so that recordings can be read and compared.
template <typename Items, typename Text>
void write_list(const LineSink& sink, const char* name, const Items& items, const Text& text_of_item) {
    sink(std::string("\"") + name + "\":[");
    for (std::size_t i = 0; i < items.size(); ++i) {
        sink((i == 0 ? "" : ",") + text_of_item(items[i], i));
    }
    sink("],");
}

std::string span_of(Tick from, Tick to) {
    return ",\"from\":" + std::to_string(from) + ",\"to\":" + std::to_string(to) + "}";
}

}  // namespace

Recording::Recording(LineSink sink, const scene::Campus& campus)
    : sink_(std::move(sink)), campus_(campus), frames_([this](const KeyFrame& key) { add_key(key); }) {}

void Recording::begin(const Walk& walk) {
    walk_ = &walk;
    ignored_layers_ = ignored_layers(campus_, walk.avatar);
    sink_(json_of(walk));
}

void Recording::on_tick(const TickRecord& record) {
    last_ = record.tick;
    if (record.tick >= next_) {  // a walk's closing record repeats its last tick
        next_ = record.tick + 1;
        sample(record);
        follow_steps(record);
    }
    for (const Event& event : record.events) {
        sink_((logged_ ? "," : "") + json_text(text_line(event, record.time)));
        logged_ = true;
        note(record, event);
    }
}

void Recording::end() {
    frames_.finish();
    sink_("],");
    write_list(sink_, "steps", steps_, [this](const Step& step, std::size_t i) {
        const engine::Step& played = walk_->steps[step.index];
        const SourceMark& mark = mark_of(played);
        return "{\"text\":" + json_text(text_of(played)) + ",\"file\":" + json_text(mark.file) +
               ",\"line\":" + std::to_string(mark.line) +
               span_of(step.from, i + 1 < steps_.size() ? steps_[i + 1].from : last_);
    });
    write_list(sink_, "popups", popups_, [this](const Popup& popup, std::size_t) {
        return "{\"building\":" + json_text(popup.building) + ",\"title\":" + json_text(popup.title) +
               ",\"text\":" + json_text(popup.text) + span_of(popup.from, popup.to.value_or(last_));
    });
    write_list(sink_, "contacts", contacts_, [this](const Contact& contact, std::size_t) {
        return "{\"tick\":" + std::to_string(contact.from) +
               ",\"to\":" + std::to_string(contact.to.value_or(last_)) +
               ",\"object\":" + json_text(contact.object) + ",\"point\":" + triple(contact.point) +
               ",\"normal\":" + triple(contact.normal) + "}";
    });
    std::string path = "\"way\":{";
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        path += std::string("\"") + kColumns[i] + "\":[" + columns_[i] + "],";
    }
    sink_(path + "\"cut\":[" + cuts_ + "]},\"ticks\":" + std::to_string(last_) + "}");
}

void Recording::add_key(const KeyFrame& key) {
    const std::string between = keys_ == 0 ? "" : ",";
    columns_[0] += between + std::to_string(key.tick - previous_.tick);
    for (std::size_t i = 0; i < key.values.size(); ++i) {
        columns_[i + 1] += between + std::to_string(key.values[i] - previous_.values[i]);
    }
    if (key.cut) {
        cuts_ += (cuts_.empty() ? "" : ",") + std::to_string(keys_);
    }
    previous_ = key;
    ++keys_;
}

void Recording::sample(const TickRecord& record) {
    const AvatarState& avatar = record.avatar;
    const double yaw = 10.0 * degrees(avatar.yaw);
    const double turned = yaw - yaw_;
    yaw_ = record.tick == 0 ? yaw : yaw_ + turned - kTurn * std::floor(turned / kTurn + 0.5);
    const bool placed =
        record.tick == 0 || std::ranges::any_of(record.events, [](const Event& event) {
            return event.kind == EventKind::avatar_spawn || event.kind == EventKind::avatar_teleport;
        });
    frames_.add({record.tick,
                 {kMillimetres * avatar.position.x(), kMillimetres * avatar.position.y(),
                  kMillimetres * avatar.position.z(), yaw_, 10.0 * degrees(avatar.pitch)}},
                placed);
}

/// A step that takes time begins in the tick after the one in which the step before it ended; instant ones
/// are executed at the end of that tick.
void Recording::follow_steps(const TickRecord& record) {
    const std::size_t count = walk_->steps.size();
    if (!in_step_ && steps_over_ < count) {
        steps_.push_back({steps_over_, record.tick});
        in_step_ = true;
    }
    if (record.steps_over > steps_over_) {
        for (std::size_t i = steps_over_ + 1; i < std::min(record.steps_over, count); ++i) {
            steps_.push_back({i, record.tick});
        }
        steps_over_ = record.steps_over;
        in_step_ = false;
    }
}

void Recording::note(const TickRecord& record, const Event& event) {
    switch (event.kind) {
        case EventKind::popup_open:
            open_popup(record, event);
            break;
        case EventKind::popup_close:
            close(popups_, &Popup::building, event);
            break;
        case EventKind::collision_enter:
            touch(record, event.object);
            break;
        case EventKind::collision_exit:
            close(contacts_, &Contact::object, event);
            break;
        default:
            break;
    }
}

void Recording::open_popup(const TickRecord& record, const Event& event) {
    Popup popup{event.object, "", "", event.tick, {}};
    const auto open = std::ranges::find_if(record.open_popups, [&](const OpenPopup& each) {
        return campus_.description.buildings[each.building].id == event.object;
    });
    if (open != record.open_popups.end()) {
        popup.title = open->title;
        popup.text = open->text;
    } else if (const auto* title = find_field<Text>(event, "title")) {  // closed again in the same tick
        popup.title = title->value;
    }
    popups_.push_back(std::move(popup));
}

/// Where the body touches the object: where it is nearest at the end of the tick.
void Recording::touch(const TickRecord& record, const std::string& object) {
    const AvatarProfile& avatar = walk_->avatar;
    const double foot = record.avatar.position.y();
    const collision::Segment axis =
        collision::upright_axis(record.avatar.position, avatar.radius, record.avatar.stature * avatar.height);
    const collision::QueryFilter filter{collision::Detection::solid, ignored_layers_, record.disabled};
    collision::gather_obstacles(campus_.world, filter, axis, avatar.radius + avatar.skin_width + kReach,
                                obstacles_);
    Contact contact{object, record.avatar.position, Vector3d::Zero(), record.tick, {}};
    double least = std::numeric_limits<double>::infinity();
    for (const collision::Obstacle& obstacle : obstacles_) {
        if (campus_.objects[index_of(obstacle.object)].id != object) {
            continue;
        }
        const collision::Closest closest = collision::closest(axis, obstacle);
        // One mesh may be the wall and the floor: the floor carries the body, which isn't a contact.
        const double distance = closest.distance + (closest.on_shape.y() > foot + kUnderfoot ? 0.0 : 1.0);
        if (distance < least) {
            least = distance;
            contact.point = closest.on_shape;
            const Vector3d away = closest.on_segment - closest.on_shape;
            contact.normal = away.norm() > 0.0 ? Vector3d(away.normalized()) : Vector3d(Vector3d::Zero());
        }
    }
    contacts_.push_back(std::move(contact));
}

template <typename Span>
void Recording::close(std::vector<Span>& spans, std::string Span::*name, const Event& event) {
    const auto span =
        std::ranges::find_if(spans, [&](const Span& each) { return !each.to && each.*name == event.object; });
    if (span != spans.end()) {
        span->to = event.tick;
    }
}

}  // namespace campuswalk::engine
