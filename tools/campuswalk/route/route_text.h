#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/script/avatar.h"
#include "engine/script/route.h"
#include "engine/walkspace/route/route_facts.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::route {

/// A route from one target to another, or why none was found.
struct RouteAnswer {
    std::string from;
    std::string to;
    std::optional<engine::Route> route;
    engine::RouteFacts facts;                    ///< of the route
    std::optional<engine::Reason> why_not = {};  ///< no route
};

/// None was found, but not everything was searched.
bool is_unknown(const RouteAnswer& answer);

void print_answer(const RouteAnswer& answer);
std::string answer_json(const RouteAnswer& answer);

/// A `NAME.steps.yaml` that walks the route from where `FROM` puts the avatar down.
std::string steps_yaml(const RouteAnswer& answer);

/// Plays those steps. Why they don't lead to the target; empty if they do.
std::string why_steps_fail(const scene::Campus& campus, const engine::AvatarProfile& avatar,
                           const collision::Vec3& from, const RouteAnswer& answer,
                           const std::vector<std::string>& disabled);

}  // namespace campuswalk::tools::route
