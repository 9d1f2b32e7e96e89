#include "tools/campuswalk/explore/avatar_text.h"

#include <algorithm>
#include <cmath>

#include "engine/events/decimals.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::explore {

using engine::AvatarProfile;

namespace {

/// To a billionth, so that an angle is written as somebody wrote it.
double angle_in_degrees(double radians) {
    constexpr double kBillion = 1e9;
    return std::floor(engine::degrees(radians) * kBillion + 0.5) / kBillion;
}

/// The keys of a flow map whose values differ.
class Differences {
public:
    explicit Differences(const std::string& name) : text_("{profile: " + name) {}

    template <typename Value>
    void add(const char* key, const Value& value, const Value& usual) {
        if (value != usual) {
            text_ += std::string(", ") + key + ": " + json_text(value);
            any_ = true;
        }
    }
    bool any() const { return any_; }
    std::string text() const { return text_ + "}"; }

private:
    std::string text_;
    bool any_ = false;
};

}  // namespace

std::string avatar_text(const AvatarProfile& avatar, const std::string& name, const AvatarProfile& profile) {
    Differences keys(name);
    keys.add("height", avatar.height, profile.height);
    keys.add("radius", avatar.radius, profile.radius);
    keys.add("eye_height", avatar.eye_height, profile.eye_height);
    keys.add("speed", avatar.speed, profile.speed);
    keys.add("run_speed", engine::running_speed(avatar), engine::running_speed(profile));
    keys.add("step_height", avatar.step_height, profile.step_height);
    keys.add("max_slope_deg", angle_in_degrees(avatar.max_slope), angle_in_degrees(profile.max_slope));
    keys.add("skin_width", avatar.skin_width, profile.skin_width);
    keys.add("turn_speed_deg", angle_in_degrees(avatar.turn_speed), angle_in_degrees(profile.turn_speed));
    keys.add("look_distance", avatar.look_distance, profile.look_distance);
    keys.add("ignore_layers", avatar.ignore_layers, profile.ignore_layers);
    return keys.any() ? keys.text() : name;
}

AvatarProfile crouched(AvatarProfile avatar) {
    const double height = engine::crouched_height(avatar);
    avatar.eye_height *= height / avatar.height;
    avatar.step_height = std::min(avatar.step_height, 0.5 * height);
    avatar.height = height;
    return avatar;
}

AvatarProfile widened(AvatarProfile avatar, double width) {
    avatar.radius = 0.5 * width;
    return avatar;
}

}  // namespace campuswalk::tools::explore
