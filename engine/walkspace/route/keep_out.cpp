#include "engine/walkspace/route/keep_out.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "collision/world/overlap_span.h"
#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"
#include "scene/base/glob.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::Vec3;

namespace {

/// What is named in a message, the first.
constexpr std::size_t kMostNamed = 3;
/// It is tried to do without so many at most, and on so much ground: 12,500 m² with cells of 0.25 m.
constexpr std::size_t kMostTried = 8;
constexpr std::size_t kMostNodesForTry = 200'000;

std::vector<ObjectId> objects_matching(const scene::Campus& campus, const std::string& glob) {
    std::vector<ObjectId> ids;
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        if (scene::glob_matches(glob, campus.objects[i].id)) {
            ids.push_back(static_cast<ObjectId>(i));
        }
    }
    return ids;
}

bool is_around(const Avoided& avoided, const Vec3& foot) {
    const Vec3 apart = foot - avoided.center.point;
    return flat(apart).norm() <= avoided.radius &&
           (!avoided.center.has_height || std::abs(apart.y()) <= std::max(avoided.radius, kTargetLevel));
}

Reason reason_of(const Avoided& avoided) {
    return avoided.objects ? Reason{.kind = ReasonKind::avoided_objects, .name = avoided.objects->glob}
                           : Reason{.kind = ReasonKind::avoided_circle,
                                    .name = avoided.center.label,
                                    .measured = avoided.radius};
}

/// As few of those that close every way as do so, too: none of them can be left out.
std::vector<Avoided> blocking_all(const scene::Campus& campus, RouteSettings settings,
                                  const RouteRequest& request) {
    settings.max_nodes = std::min(settings.max_nodes, kMostNodesForTry);
    std::vector<Avoided> closing = settings.avoided;
    std::size_t tried = 0;
    for (std::size_t i = closing.size(); i-- > 0 && closing.size() > 1 && tried < kMostTried; ++tried) {
        std::vector<Avoided> others = closing;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        settings.keep_out = keep_out_of(campus, others, settings.strides.body);
        const auto found = plan_route(campus.world, settings, request);
        const auto* none = std::get_if<NoRoute>(&found);
        if (none != nullptr && !none->incomplete) {
            closing = std::move(others);
        }
    }
    return closing;
}

}  // namespace

std::function<bool(const Vec3& foot)> keep_out_of(const scene::Campus& campus,
                                                  const std::vector<Avoided>& avoided,
                                                  const collision::MoverSettings& body) {
    if (avoided.empty()) {
        return {};
    }
    std::vector<ObjectId> objects;
    std::vector<Avoided> areas;
    for (const Avoided& each : avoided) {
        if (each.objects) {
            std::ranges::copy(objects_matching(campus, each.objects->glob), std::back_inserter(objects));
        } else {
            areas.push_back(each);
        }
    }
    const double radius = body.radius + body.skin + kTouchSlack;
    return [&campus, body, radius, objects = std::move(objects), areas = std::move(areas)](const Vec3& foot) {
        const auto touches = [&](ObjectId id) {
            const collision::Segment core = body.core(foot);
            return campus.world.bounds(id).grown(radius).overlaps({core.a, core.b}) &&
                   collision::overlap_span(campus.world, id, core, radius, Vec3::Zero()).has_value();
        };
        return std::ranges::any_of(areas, [&](const Avoided& area) { return is_around(area, foot); }) ||
               std::ranges::any_of(objects, touches);
    };
}

Reason why_avoided(const scene::Campus& campus, const RouteSettings& settings, const RouteRequest& request) {
    const std::vector<Avoided> closing = blocking_all(campus, settings, request);
    Reason reason{.kind = ReasonKind::avoided};
    for (const Avoided& each : closing) {
        if (reason.parts.size() < kMostNamed) {
            reason.parts.push_back(reason_of(each));
        } else {
            ++reason.more;
        }
    }
    return reason;
}

}  // namespace campuswalk::engine
