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
                     .contact = Eigen::Vector3d(1.0 / 7.0, 1.25, -7.5),
                     .last_events = {"000240    4.000000 ray.enter library/walls",
                                     "000243    4.050000 ray.exit library/walls"}};
    const Eigen::Vector3d place(1.0 / 3.0, 0.45, -7.5);
    failure.reason = Reason{.kind = ReasonKind::enclosed,
                            .object = "library/walls",
                            .node = "door",
                            .is_node = true,
                            .name = "library",
                            .at = place,
                            .measured = 1.0 / 7.0,
                            .allowed = 0.3,
                            .detour = 12.5,
                            .from = place,
                            .room = place,
                            .look_at = place,
                            .more = 2};
    failure.reason->parts = {Reason{.kind = ReasonKind::slope, .measured = 61.0, .allowed = 50.0}};
    failure.object = "library/walls";
    failure.route = RouteHint{"library", 12.5, {{1.0 / 3.0, 0, 2}}, true};
    failure.actual = "2";
    failure.expected = "at least 3";
    WalkResult result;
    result.id = "walks/visit.walk.yaml kiosk #2";
    result.file = "walks/visit.walk.yaml";
    result.name = "visit";
    result.project = "kiosk";
    result.config = "walks.config.yaml";
    result.repetition = 2;
    result.tags = {"smoke", "library"};
    result.status_reason = "the door is to be widened";
    result.expected_to_fail = true;
    result.outcome = Outcome::broken;
    result.failures = {failure};
    result.diagnostics = {{{}, {"walks/visit.walk.yaml", 3, 1}, "bad-value", "speed must be > 0"}};
    result.campus = "school";
    result.ticks_per_second = 120;
    result.timeout = 12.1;
    result.ticks = 486;
    result.events = 17;
    result.distance = 12.345678901234567;
    result.hash = 0x00f1e2d3c4b5a697ULL;
    result.artifacts = {{"gate", "visit/gate.png", "image/png"}};
    return result;
}

WalkResult passed_result(const std::string& name) {
    WalkResult result;
    result.name = name;
    result.file = "walks/" + name + ".walk.yaml";
    result.id = result.file;
    result.campus = "school";
    result.ticks = 240;
    result.events = 9;
    result.distance = 5.0;
    result.hash = 0xabcdefULL;
    return result;
}

WalkResult failed_result(const std::string& name) {
    WalkResult result = passed_result(name);
    result.outcome = Outcome::failed;
    result.failures = full_result().failures;
    result.failures[0].mark.file = result.file;
    result.artifacts = {{"failure from above", name + "/failure-above.png", "image/png"}};
    return result;
}

WalkResult skipped_result(const std::string& name) {
    WalkResult result = passed_result(name);
    result.outcome = Outcome::skipped;
    result.status_reason = "the lift is out of order";
    result.ticks = 0;
    result.distance = 0.0;
    return result;
}

WalkResult xfail_result(const std::string& name) {
    WalkResult result = failed_result(name);
    result.outcome = Outcome::passed;
    result.expected_to_fail = true;
    result.status_reason = "the door is too narrow";
    return result;
}

WalkResult bad_input_result(const std::string& name) {
    WalkResult result = skipped_result(name);
    result.outcome = Outcome::bad_input;
    result.status_reason.clear();
    result.diagnostics = {{{}, {result.file, 3, 1}, "bad-value", "speed must be > 0"}};
    return result;
}

RunReport mixed_report() {
    WalkResult wrong = passed_result("wrong");
    wrong.outcome = Outcome::failed;
    wrong.expected_to_fail = true;
    wrong.status_reason = "the door is too narrow";
    wrong.failures = {{{"walks/wrong.walk.yaml", 3, 9},
                       "xfail",
                       "expected to fail because the door is too narrow, but passed",
                       {}}};
    WalkResult broken = skipped_result("broken");
    broken.outcome = Outcome::broken;
    broken.status_reason.clear();
    WalkResult stopped = broken;
    stopped.outcome = Outcome::interrupted;
    stopped.name = "stopped";
    stopped.file = stopped.id = "walks/stopped.walk.yaml";
    WalkResult kiosk = passed_result("arrive");
    kiosk.project = "kiosk";
    kiosk.id += " kiosk";
    return {{passed_result("arrive"), kiosk, failed_result("visit"), skipped_result("lift"),
             xfail_result("door"), wrong, bad_input_result("typo"), broken, stopped}};
}

RunReport hostile_report() {
    std::string odd =
        "]]> --> <b> & \" ' % # \\ :, ::error:: \r\n\t \x1b[31m \x7f caf\xe9 \xed\xa0\x80 "
        "\xef\xbf\xbf \u2028 \u56f3";
    odd.insert(0, std::string(1, '\0') + "\x01");
    WalkResult result = failed_result("odd");
    result.id = result.name = result.file = result.project = odd;
    result.status_reason = result.campus = odd;
    result.tags = {odd};
    result.diagnostics = {
        {{}, {odd, 1, 1}, "bad-value", odd}, {{}, {}, {}, odd}, {{}, {": error :", 0, 0}, {}, ""}};
    Failure& failure = result.failures[0];
    failure.code = failure.message = failure.mark.file = odd;
    failure.scene.building = failure.scene.nearest = odd;
    failure.scene.last_events = {odd};
    result.artifacts = {{odd, odd, odd}};
    WalkResult broken = result;
    broken.outcome = Outcome::broken;
    WalkResult xfail = result;
    xfail.outcome = Outcome::passed;
    xfail.expected_to_fail = true;
    WalkResult skipped = result;
    skipped.outcome = Outcome::skipped;
    return {{result, broken, xfail, skipped}};
}

RunPlan plan_of(const RunReport& report) {
    const std::size_t cases = report.results.size();
    return {.cases = cases, .all_cases = cases, .contents = "0a1b", .division = "2c3d"};
}

std::vector<std::string> reporters_of_results() {
    std::vector<std::string> names = reporter_names();
    std::erase(names, "html");
    return names;
}

std::string written(std::string_view reporter, const RunReport& report, const ReportStyle& style) {
    std::string text;
    const auto made = make_reporter(
        reporter, [&](std::string_view part) { text += part; }, style);
    made->begin(plan_of(report));
    for (const WalkResult& result : report.results) {
        made->result(result);
    }
    made->end(report);
    return text;
}

}  // namespace campuswalk::engine
