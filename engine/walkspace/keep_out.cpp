#include "engine/walkspace/keep_out.h"

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

}  // namespace campuswalk::engine
