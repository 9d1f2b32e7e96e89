#include "engine/walkspace/barrier/place_check.h"

#include "collision/world/placement.h"
#include "engine/script/avatar_body.h"
#include "engine/script/travel.h"
#include "engine/walkspace/barrier/barrier_reason.h"

namespace campuswalk::engine {

using collision::Vec3;

PlaceCheck check_place(const scene::Campus& campus, Strider& strider, const Vec3& point) {
    const collision::MoverSettings& body = strider.settings().body;
    const collision::World& world = strider.world();
    const StrideEnd end = strider.put_down(point);
    const bool grounded = end.kind == StrideEnd::Kind::grounded;
    if (const auto object = grounded
                                ? std::nullopt
                                : collision::obstruction(world, strider.filter(), point + Vec3(0, 0.02, 0),
                                                         body.radius, body.height)) {
        const auto free = collision::nearest_free_placement(world, strider.filter(), point, body.radius,
                                                            body.height, kPlacementSearch);
        if (!free) {
            const Vec3 middle = point + 0.5 * body.height * Vec3::UnitY();
            Reason problem = reason_about(ReasonKind::inside, campus, *object, middle);
            problem.at.reset();
            return {std::nullopt, std::move(problem)};
        }
    }
    if (!grounded) {
        return {std::nullopt, {.kind = ReasonKind::no_ground}};
    }
    if (const double drop = point.y() - end.at.foot.y(); drop > kTargetLevel) {
        return {std::nullopt, {.kind = ReasonKind::ground_far_below, .measured = drop}};
    }
    return {end.at};
}

}  // namespace campuswalk::engine
