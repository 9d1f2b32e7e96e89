#include "config/loader/read_walk.h"

#include "config/loader/ranges.h"
#include "config/loader/read_camera.h"
#include "config/loader/read_expectations.h"
#include "config/loader/read_status.h"
#include "config/loader/read_steps.h"

namespace campuswalk::config {

namespace {

engine::SimSettings read_sim(const CheckedNode& node) {
    constexpr int kMostTicks = 10'000;  // a second
    engine::SimSettings sim;
    CheckedMap map(node, "'sim'");
    map.whole_number("ticks_per_second", 1, kMostTicks, sim.ticks_per_second);
    map.number("stay_every", kSeconds, sim.stay_every);
    map.number("gaze_hold", kSeconds, sim.gaze_hold);
    if (const auto seed = map.find("seed")) {
        seed->diagnostics().warning(seed->mark(), "deprecated",
                                    "'seed' is ignored, nothing draws random numbers; remove it");
    }
    map.refuse_other_keys();
    return sim;
}

CameraKeys read_camera(const CheckedNode& node, const CampusNames& names) {
    CameraKeys camera;
    CheckedMap map(node, "'camera'");
    read_camera_fields(map, names, camera);
    map.refuse_other_keys();
    return camera;
}

}  // namespace

void read_walk(CheckedMap& map, const CampusNames& names, const std::filesystem::path& walk_file,
               engine::Walk& walk) {
    if (const auto sim = map.find("sim")) {
        walk.sim = read_sim(*sim);
    }
    if (const auto status = map.find("status")) {
        walk.status = read_status(*status);
    }
    if (const auto tags = map.find("tags")) {
        walk.tags = read_tags(*tags);
    }
    map.number("timeout", kTimeout, walk.timeout);
    CameraKeys camera;
    if (const auto node = map.find("camera")) {
        camera = read_camera(*node, names);
    }
    walk.camera = camera.settings();
    walk.views = camera.views();
    if (const auto steps = map.require("steps")) {
        walk.steps = read_steps(*steps, names, walk.avatar, camera, walk_file);
    }
    if (const auto expect = map.find("expect")) {
        walk.expectations = read_expectations(*expect, names);
    }
}

}  // namespace campuswalk::config
