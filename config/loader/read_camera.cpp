#include "config/loader/read_camera.h"

#include <array>

#include "config/loader/ranges.h"

namespace campuswalk::config {

using engine::View;

void read_camera_fields(CheckedMap& map, engine::CameraSettings& camera) {
    constexpr std::array kViews = {Choice<View>{"first_person", View::first_person},
                                   Choice<View>{"third_person", View::third_person},
                                   Choice<View>{"top", View::top}};
    constexpr int kLeastPixels = 16;
    constexpr int kMostPixels = 8192;
    map.choice("view", kViews, camera.view);
    map.whole_number("width", kLeastPixels, kMostPixels, camera.width);
    map.whole_number("height", kLeastPixels, kMostPixels, camera.height);
    map.angle("fov_deg", kFieldOfView, camera.fov);
    map.number("height_above", kLength, camera.height_above);
    map.number("distance", kLength, camera.distance);
}

}  // namespace campuswalk::config
