#include "tests/engine/report/some_results.h"

namespace campuswalk::engine {

WalkResult full_result() {
    Failure failure;
    failure.mark = {"walks/visit.walk.yaml", 12, 5};
    failure.code = "sequence";
    failure.message = "popup.open library never came; last was \"ray.exit library/walls\"";
    failure.scene = {.tick = 243,
                     .time = 4.05,
                     .position = {1.0 / 3.0, -0.125, -7.3096},
                     .yaw = 0.7853981633974483,
                     .pitch = -0.1,
                     .building = "library",
                     .nearest = "library/walls",
                     .nearest_distance = 0.42,
                     .last_events = {"000240    4.000000 ray.enter library/walls",
                                     "000243    4.050000 ray.exit library/walls"}};
    WalkResult result;
    result.id = "walks/visit.walk.yaml kiosk #2";
    result.file = "walks/visit.walk.yaml";
    result.name = "visit";
    result.project = "kiosk";
    result.repetition = 2;
    result.tags = {"smoke", "library"};
    result.status_reason = "the door is to be widened";
    result.expected_to_fail = true;
    result.outcome = Outcome::broken;
    result.failures = {failure};
    result.complaints = {"walks/visit.walk.yaml:3:1: error bad-value: speed must be > 0"};
    result.campus = "school";
    result.ticks_per_second = 120;
    result.seed = 18446744073709551615ULL;
    result.ticks = 486;
    result.events = 17;
    result.distance = 12.345678901234567;
    result.hash = 0x00f1e2d3c4b5a697ULL;
    result.artifacts = {{"gate", "visit/gate.png", "image/png"}};
    return result;
}

}  // namespace campuswalk::engine
