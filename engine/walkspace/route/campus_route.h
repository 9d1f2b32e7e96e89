#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "engine/script/avatar.h"
#include "engine/walkspace/route/route.h"
#include "engine/walkspace/route/unreachable.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Of a body of this profile at 60 Hz. `disabled`: by object; null: none is; must outlive the settings' use.
RouteSettings route_settings(const scene::Campus& campus, const AvatarProfile& avatar,
                             const std::vector<bool>* disabled);

/// Where routes from a target start: a point without a height is meant at that of the first spawn.
collision::Vec3 route_start(const Target& from, const scene::CampusDescription& campus);
/// A body that is put down there as a spawn is; none if it doesn't fit.
std::optional<collision::MoverState> body_at(const collision::Vec3& start, const scene::Campus& campus,
                                             const RouteSettings& settings);

/// The route, or why there is none, as `why_unreachable` says it.
std::variant<Route, Reason> route_or_reason(const scene::Campus& campus, const RouteSettings& settings,
                                            const RouteRequest& request);

}  // namespace campuswalk::engine
