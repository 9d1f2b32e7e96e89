#include "engine/report/result_text.h"

#include <array>
#include <utility>

#include "engine/events/decimals.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::engine {

namespace {

std::size_t& count_of(Tally& tally, Outcome outcome) {
    switch (outcome) {
        case Outcome::passed:
            return tally.passed;
        case Outcome::failed:
            return tally.failed;
        case Outcome::skipped:
            return tally.skipped;
        case Outcome::bad_input:
            return tally.bad_input;
        case Outcome::broken:
            return tally.broken;
        default:
            return tally.interrupted;
    }
}

}  // namespace

double seconds_of(const WalkResult& result) {
    return result.ticks_per_second > 0 ? static_cast<double>(result.ticks) / result.ticks_per_second : 0.0;
}

std::string verdict_in_words(const WalkResult& result) {
    switch (result.outcome) {
        case Outcome::interrupted:
            return "interrupted before it ended";
        case Outcome::broken:
            return result.diagnostics.empty() ? "it ended without a result" : "";
        default:
            return "";
    }
}

std::string not_evaluated_in_words(std::size_t not_evaluated) {
    return not_evaluated == 0
               ? ""
               : std::to_string(not_evaluated) + (not_evaluated == 1 ? " expectation" : " expectations") +
                     " not evaluated";
}

std::string headline_of(const Failure& failure) {
    return scene::error_line(failure.mark, failure.code, failure.message);
}

std::string place_of(const FailureScene& scene) {
    if (scene.tick == 0 && scene.last_events.empty() && scene.nearest.empty()) {
        return "";
    }
    std::string place = "at " + fixed(scene.time, 3) + " s, " + fixed(scene.position) + ", facing " +
                        fixed(degrees(scene.yaw), 1) + " degrees";
    if (!scene.building.empty()) {
        place += "; in or near " + scene.building;
    }
    if (!scene.nearest.empty()) {
        place += "; nearest " + scene.nearest + ", " + fixed(scene.nearest_distance, 2) + " m away";
    }
    return place;
}

void Tally::add(const WalkResult& result) {
    ++count_of(*this, result.outcome);
    expected_failures += failed_as_expected(result) ? 1U : 0U;
    not_evaluated += result.not_evaluated;
    seconds += seconds_of(result);
    distance += result.distance;
}

std::string summary_of(const Tally& tally) {
    std::string text = std::to_string(tally.passed) + " passed";
    if (tally.expected_failures > 0) {
        text += " (" + std::to_string(tally.expected_failures) + " by failing as expected)";
    }
    const std::array<std::pair<std::size_t, const char*>, 5> others = {{{tally.failed, " failed"},
                                                                        {tally.skipped, " skipped"},
                                                                        {tally.bad_input, " with bad input"},
                                                                        {tally.broken, " broken"},
                                                                        {tally.interrupted, " interrupted"}}};
    for (const auto& [count, what] : others) {
        if (count > 0) {
            text += ", " + std::to_string(count) + what;
        }
    }
    if (tally.not_evaluated > 0) {
        text += ", " + not_evaluated_in_words(tally.not_evaluated);
    }
    return text + ": " + fixed(tally.seconds, 1) + " simulated seconds, " + fixed(tally.distance, 1) + " m";
}

}  // namespace campuswalk::engine
