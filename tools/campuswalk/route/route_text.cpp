#include "tools/campuswalk/route/route_text.h"

#include <cmath>

#include "engine/events/decimals.h"
#include "engine/script/walk.h"
#include "engine/simulation/run_walk.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"

namespace campuswalk::tools::route {

using collision::Vec3;
using engine::fixed;
using engine::RoutePiece;

namespace {

double seconds_of(const engine::Route& route) {
    return engine::SimSettings().seconds_at(route.ticks());
}

/// Where each piece ends.
std::vector<Vec3> waypoints(const engine::Route& route) {
    std::vector<Vec3> points{route.path.front()};
    engine::Tick tick = 0;
    for (const RoutePiece& piece : route.pieces) {
        tick += piece.ticks;
        points.push_back(route.path[static_cast<std::size_t>(tick)]);
    }
    return points;
}

Json json_of(const Vec3& p) {
    const auto rounded = [](double value) { return std::floor(value * 1e5 + 0.5) / 1e5; };
    return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

/// Exactly: pieces go to whole millimetres. A target's own coordinates are written as they are.
std::string coordinate_text(double value) {
    return Json(value).dump();
}

}  // namespace

bool is_unknown(const RouteAnswer& answer) {
    return answer.why_not && is_unsearched(*answer.why_not);
}

void print_answer(const RouteAnswer& answer) {
    if (!answer.route) {
        print_line("%s from %s to %s: %s",
                   is_unknown(answer) ? "it isn't known whether there is a route" : "no route",
                   answer.from.c_str(), answer.to.c_str(), text_of(*answer.why_not).c_str());
        return;
    }
    const engine::Route& route = *answer.route;
    print_line("route      %s to %s", answer.from.c_str(), answer.to.c_str());
    print_line("length     %s m, %s s, climb %s m", fixed(route.length(), 2).c_str(),
               fixed(seconds_of(route), 1).c_str(), fixed(route.climb(), 2).c_str());
    if (const auto& narrowest = answer.facts.narrowest) {
        print_line("narrowest  %s m at %s", fixed(narrowest->value, 2).c_str(),
                   engine::coordinates_text(narrowest->at).c_str());
    } else {
        print_line("narrowest  nowhere less than %s m", fixed(engine::RouteFacts::kWidest, 1).c_str());
    }
    const engine::RouteFacts::Spot& steepest = answer.facts.steepest;
    print_line("steepest   %s degrees at %s", fixed(engine::degrees(steepest.value), 1).c_str(),
               engine::coordinates_text(steepest.at).c_str());
    const std::vector<Vec3> points = waypoints(route);
    print_line("waypoints  %zu", points.size());
    for (const Vec3& point : points) {
        print_line("  %s", engine::coordinates_text(point).c_str());
    }
}

std::string answer_json(const RouteAnswer& answer) {
    Json json = {{"campuswalk_route", 1},
                 {"from", answer.from},
                 {"to", answer.to},
                 {"reachable", is_unknown(answer) ? Json() : Json(answer.route.has_value())}};
    if (!answer.route) {
        json["reason"] = text_of(*answer.why_not);
        return json_text(json, 2) + "\n";
    }
    const engine::Route& route = *answer.route;
    json["length"] = route.length();
    json["seconds"] = seconds_of(route);
    json["climb"] = route.climb();
    const auto& narrowest = answer.facts.narrowest;
    json["narrowest"] =
        narrowest ? Json{{"width", narrowest->value}, {"at", json_of(narrowest->at)}} : Json();
    json["steepest"] = {{"degrees", engine::degrees(answer.facts.steepest.value)},
                        {"at", json_of(answer.facts.steepest.at)}};
    json["waypoints"] = Json::array();
    for (const Vec3& point : waypoints(route)) {
        json["waypoints"].push_back(json_of(point));
    }
    return json_text(json, 2) + "\n";
}

std::string steps_yaml(const RouteAnswer& answer) {
    std::string yaml = "# From " + json_text(Json(answer.from)) + " to " + json_text(Json(answer.to)) +
                       ", written by `campuswalk route`.\nsteps:\n";
    engine::Tick tick = 0;
    for (const RoutePiece& piece : answer.route->pieces) {
        tick += piece.ticks;
        const Vec3& end = answer.route->path[static_cast<std::size_t>(tick)];
        if (piece.stride && piece.stride->isZero(0.0)) {
            // A ten thousandth less than the ticks take is as many ticks.
            const double seconds = engine::SimSettings().seconds_at(piece.ticks);
            yaml += "  - wait: " + fixed(std::floor(seconds * 1e4) / 1e4, 4) + "\n";
            continue;
        }
        const Vec3& to = piece.stride ? end : piece.target.point;
        const bool last = &piece == &answer.route->pieces.back();
        const std::string height = last && piece.target.has_height ? coordinate_text(to.y()) + ", " : "";
        yaml += "  - walk_to: [" + coordinate_text(to.x()) + ", " + height + coordinate_text(to.z()) + "]\n";
    }
    return yaml;
}

std::string why_steps_fail(const scene::Campus& campus, const engine::AvatarProfile& avatar, const Vec3& from,
                           const RouteAnswer& answer, const std::vector<std::string>& disabled) {
    engine::Walk walk;
    walk.name = "route";
    walk.avatar = avatar;
    walk.steps.emplace_back(engine::SpawnStep{{}, answer.from, from, 0.0});
    for (const std::string& glob : disabled) {
        walk.steps.emplace_back(engine::EnableStep{{}, {{{}, glob}}, false});
    }
    engine::Tick tick = 0;
    for (const RoutePiece& piece : answer.route->pieces) {
        tick += piece.ticks;
        if (piece.stride && piece.stride->isZero(0.0)) {
            walk.steps.emplace_back(engine::WaitStep{{}, engine::SimSettings().seconds_at(piece.ticks)});
            continue;
        }
        engine::WalkToStep step;
        step.target = piece.target;
        if (piece.stride) {
            step.target.point = answer.route->path[static_cast<std::size_t>(tick)];
            step.target.has_height = false;
        }
        walk.steps.emplace_back(std::move(step));
    }
    const engine::WalkSummary played = engine::run_walk(campus, walk, {});
    return played.passed ? "" : played.failures.front().message;
}

}  // namespace campuswalk::tools::route
