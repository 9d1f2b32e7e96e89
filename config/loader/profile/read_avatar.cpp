#include "config/loader/profile/read_avatar.h"

#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

using engine::AvatarProfile;

namespace {

// From a lawn mower to a crane.
constexpr Range kHeight{0.05, 100.0, false, "m"};
constexpr Range kRadius{0.01, 50.0, false, "m"};
constexpr Range kStepHeight{0.0, 50.0, false, "m"};
constexpr Range kSkin{0.001, 0.5, false, "m"};
constexpr Range kTurnSpeed{0.0, 36'000.0, true, "degrees per second"};
constexpr Range kLookDistance{0.0, 10'000.0, false, "m"};

/// Checks values against each other; the range of each has been checked already.
void check_body(const CheckedMap& map, const AvatarProfile& profile) {
    if (profile.height < 2.0 * profile.radius) {
        map.diagnose_at(map.has("height") ? "height" : "radius", "bad-value",
                        "the body is a capsule: its height of " + shown_number(profile.height) +
                            " m must be at least twice its radius of " + shown_number(profile.radius) + " m");
    }
    if (profile.eye_height > profile.height) {
        map.diagnose_at(map.has("eye_height") ? "eye_height" : "height", "bad-value",
                        "'eye_height' of " + shown_number(profile.eye_height) +
                            " m must not exceed the height of " + shown_number(profile.height) + " m");
    }
    if (profile.step_height > 0.5 * profile.height) {
        map.diagnose_at(map.has("step_height") ? "step_height" : "height", "bad-value",
                        "'step_height' of " + shown_number(profile.step_height) +
                            " m must be at most half the height of " + shown_number(profile.height) + " m");
    }
}

}  // namespace

std::vector<CheckedNode> read_profile_fields(CheckedMap& map, AvatarProfile& profile) {
    map.number("height", kHeight, profile.height);
    map.number("radius", kRadius, profile.radius);
    map.number("eye_height", kHeight, profile.eye_height);
    map.number("speed", kSpeed, profile.speed);
    map.number("run_speed", kSpeed, profile.run_speed);
    map.number("step_height", kStepHeight, profile.step_height);
    map.angle("max_slope_deg", kSlope, profile.max_slope);
    map.number("skin_width", kSkin, profile.skin_width);
    map.angle("turn_speed_deg", kTurnSpeed, profile.turn_speed);
    map.number("look_distance", kLookDistance, profile.look_distance);
    check_body(map, profile);
    std::vector<CheckedNode> layers;
    if (const auto section = map.find("ignore_layers")) {
        profile.ignore_layers.clear();
        for (const CheckedNode& node : section->items_or_one("a layer")) {
            if (auto name = id_word(node)) {
                profile.ignore_layers.push_back(*std::move(name));
                layers.push_back(node);
            }
        }
    }
    return layers;
}

}  // namespace campuswalk::config
