#include "config/loader/walk/read_camera.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

#include "config/loader/values/ranges.h"

namespace campuswalk::config {

using engine::View;

namespace {

using ViewMaker = View (*)(const CameraKeys&);

constexpr std::array kViews = {
    Choice<ViewMaker>{"first_person", [](const CameraKeys&) -> View { return engine::FirstPersonView{}; }},
    Choice<ViewMaker>{"third_person",
                      [](const CameraKeys& keys) -> View { return engine::ThirdPersonView{keys.distance}; }},
    Choice<ViewMaker>{"top",
                      [](const CameraKeys& keys) -> View { return engine::TopView{keys.height_above}; }},
    Choice<ViewMaker>{"orbit",
                      [](const CameraKeys& keys) -> View {
                          return engine::OrbitView{keys.around, keys.distance, keys.yaw, keys.pitch};
                      }},
    Choice<ViewMaker>{"fixed", [](const CameraKeys& keys) -> View {
                          return engine::FixedView{keys.position, keys.look_at, keys.yaw, keys.pitch};
                      }}};
static_assert(kViews.size() == std::variant_size_v<View>);

constexpr Range kPitch{-90.0, 90.0, false, "degrees"};

/// The viewing direction of a camera that isn't the avatar's: angles, or a target. Either replaces the other
/// if the walk's camera has set that.
void read_direction(CheckedMap& map, const CampusNames& names, CameraKeys& camera) {
    const auto look_at = map.find("look_at");
    std::optional<double> yaw;
    std::optional<double> pitch;
    map.angle("yaw_deg", kYaw, yaw);
    map.angle("pitch_deg", kPitch, pitch);
    if (look_at && (yaw || pitch)) {
        look_at->diagnose("bad-value",
                          "'look_at' sets the direction, and so do 'yaw_deg' and 'pitch_deg'; "
                          "use one or the other");
        return;
    }
    if (look_at) {
        camera.look_at = names.camera_target(*look_at);
        camera.yaw.reset();
        camera.pitch.reset();
    }
    if (yaw || pitch) {
        camera.look_at.reset();
        camera.yaw = yaw ? yaw : camera.yaw;
        camera.pitch = pitch ? pitch : camera.pitch;
    }
}

}  // namespace

engine::CameraSettings CameraKeys::settings() const {
    engine::CameraSettings settings = size;
    if (view != nullptr) {
        settings.view = view(*this);
    }
    return settings;
}

engine::Views CameraKeys::views() const {
    engine::Views views = engine::default_views();
    for (const Choice<ViewMaker>& kind : kViews) {
        View made = kind.value(*this);
        views[made.index()] = std::move(made);
    }
    return views;
}

void read_camera_fields(CheckedMap& map, const CampusNames& names, CameraKeys& camera) {
    constexpr int kMinPixels = 16;
    constexpr int kMaxPixels = 8192;
    map.choice("view", kViews, camera.view);
    map.as_int("width", kMinPixels, kMaxPixels, camera.size.width);
    map.as_int("height", kMinPixels, kMaxPixels, camera.size.height);
    map.angle("fov_deg", kFieldOfView, camera.size.fov);
    map.number("height_above", kPositiveLength, camera.height_above);
    map.number("distance", kPositiveLength, camera.distance);
    if (const auto around = map.find("around")) {
        camera.around = names.camera_target(*around);
    }
    map.vector("position", kCoordinate, camera.position);
    read_direction(map, names, camera);
}

void refuse_unused_keys(CheckedMap& map, const View& view) {
    constexpr std::size_t kMaxViews = 2;
    struct KeyOfViews {
        const char* key;
        std::array<const char*, kMaxViews> views;
    };
    constexpr std::array<KeyOfViews, 7> kKeys = {{{"height_above", {"top", ""}},
                                                  {"distance", {"third_person", "orbit"}},
                                                  {"around", {"orbit", ""}},
                                                  {"position", {"fixed", ""}},
                                                  {"look_at", {"fixed", ""}},
                                                  {"yaw_deg", {"orbit", "fixed"}},
                                                  {"pitch_deg", {"orbit", "fixed"}}}};
    const std::string name(kViews[view.index()].name);
    for (const auto& [key, views] : kKeys) {
        const auto node = map.find(key);
        if (node && std::ranges::find(views, name) == views.end()) {
            const std::string others = std::string(views[0]) + (*views[1] != '\0' ? " or " : "") + views[1];
            std::string message = std::string("'") + key;
            message.append("' has no effect on a ").append(name);
            message.append(" view; it is for view: ").append(others);
            node->diagnose("bad-value", message);
        }
    }
}

engine::ImageChannels read_channels(const CheckedNode& node) {
    using Channel = bool engine::ImageChannels::*;
    constexpr std::array kChannels = {Choice<Channel>{"depth", &engine::ImageChannels::depth},
                                      Choice<Channel>{"ids", &engine::ImageChannels::ids},
                                      Choice<Channel>{"normals", &engine::ImageChannels::normals}};
    engine::ImageChannels channels;
    for (const CheckedNode& item : node.items_or_one("a channel")) {
        if (const auto channel = item.choice(kChannels)) {
            channels.** channel = true;
        }
    }
    return channels;
}

void read_overlays(const CheckedNode& node, engine::ImageOverlays& overlays) {
    using Overlays = engine::ImageOverlays;
    using Overlay = bool Overlays::*;
    constexpr std::array kOverlays = {Choice<Overlay>{"path", &Overlays::path},
                                      Choice<Overlay>{"contacts", &Overlays::contacts},
                                      Choice<Overlay>{"colliders", &Overlays::colliders},
                                      Choice<Overlay>{"triggers", &Overlays::triggers},
                                      Choice<Overlay>{"labels", &Overlays::labels},
                                      Choice<Overlay>{"compass", &Overlays::compass},
                                      Choice<Overlay>{"grid", &Overlays::grid},
                                      Choice<Overlay>{"walkspace", &Overlays::walkspace}};
    for (const CheckedNode& item : node.items_or_one("an overlay")) {
        if (const auto overlay = item.choice(kOverlays)) {
            overlays.** overlay = true;
        }
    }
}

}  // namespace campuswalk::config
