#include "engine/walkspace/route/route_facts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/geometry/trigonometry.h"
#include "collision/world/obstacle.h"
#include "engine/script/travel.h"

namespace campuswalk::engine {

using collision::Closest;
using collision::Obstacle;
using collision::Vec3;

namespace {

/// Between two places that are looked at, metres.
constexpr double kSpacing = 0.03;
/// Cosine of how far what stands at a side may be from straight left or right.
constexpr double kSideways = 0.95;
/// What leans more than this is ground or ceiling, no side: rise over run of the nearest way to it.
constexpr double kLeans = 0.5;
/// Ground this far from the body carries it, metres.
constexpr double kCarries = 2e-3;

class Survey {
public:
    Survey(const collision::World& world, const collision::MoverSettings& body,
           const collision::QueryFilter& solids)
        : world_(world), body_(body), solids_(solids) {}

    void look(const Vec3& foot, const Vec3& ahead) {
        look_sideways(foot, ahead);
        look_down(foot);
    }

    const RouteFacts& facts() const { return facts_; }

private:
    void look_sideways(const Vec3& foot, const Vec3& ahead) {
        const Vec3 left(ahead.z(), 0.0, -ahead.x());
        const collision::Segment spine{foot + Vec3(0, body_.step_height + 0.02, 0),
                                       foot + Vec3(0, body_.height, 0)};
        collision::gather_obstacles(world_, solids_, spine, 0.5 * RouteFacts::kWidest, near_);
        double nearest[2] = {RouteFacts::kWidest, RouteFacts::kWidest};
        for (const Obstacle& piece : near_) {
            const Closest c = collision::closest(spine, piece);
            const bool beyond = c.on_shape.y() < spine.a.y() || c.on_shape.y() > spine.b.y();
            if (beyond && collision::walkable_at(piece, c.on_shape, body_.min_up)) {
                continue;  // ground, a step or a ceiling, however finely it is divided
            }
            const Vec3 gap = c.on_shape - c.on_segment;
            const double distance = flat(gap).norm();
            const double sideways = distance > 0.0 ? flat(gap).dot(left) / distance : 0.0;
            if (std::abs(gap.y()) <= kLeans * distance && std::abs(sideways) >= kSideways) {
                double& side = nearest[sideways > 0.0 ? 0 : 1];
                side = std::min(side, distance);
            }
        }
        const double width = nearest[0] + nearest[1];
        if (width < (facts_.narrowest ? facts_.narrowest->value : RouteFacts::kWidest)) {
            facts_.narrowest = RouteFacts::Spot{width, foot};
        }
    }

    void look_down(const Vec3& foot) {
        const Vec3 center = foot + Vec3(0, body_.radius, 0);
        collision::gather_obstacles(world_, solids_, {center, center}, body_.radius + kCarries, near_);
        for (const Obstacle& piece : near_) {
            const Vec3 at = collision::closest({center, center}, piece).on_shape;
            if (collision::walkable_at(piece, at, body_.min_up)) {
                const double up = up_at(piece, at);
                const double slope = collision::angle_of(std::sqrt(std::max(0.0, 1.0 - up * up)), up);
                if (slope > facts_.steepest.value) {
                    facts_.steepest = {slope, foot};
                }
            }
        }
    }

    /// The cosine of the slope there, by halving.
    double up_at(const Obstacle& piece, const Vec3& at) const {
        double yes = body_.min_up;
        double no = 1.0;
        if (collision::walkable_at(piece, at, 1.0 - 1e-9)) {
            return 1.0;
        }
        for (int i = 0; i < 24; ++i) {
            const double middle = 0.5 * (yes + no);
            (collision::walkable_at(piece, at, middle) ? yes : no) = middle;
        }
        return yes;
    }

    const collision::World& world_;
    const collision::MoverSettings& body_;
    const collision::QueryFilter& solids_;
    std::vector<Obstacle> near_;
    RouteFacts facts_;
};

}  // namespace

RouteFacts facts_of(const Route& route, const collision::World& world, const collision::MoverSettings& body,
                    const collision::QueryFilter& solids) {
    Survey survey(world, body, solids);
    Vec3 last = route.path.front();
    bool first = true;
    for (std::size_t i = 1; i < route.path.size(); ++i) {
        const Vec3 ahead = flat(route.path[i] - route.path[i - 1]);
        const bool far = (route.path[i] - last).norm() >= kSpacing;
        if (ahead.norm() > 0.0 && (first || far || i + 1 == route.path.size())) {
            survey.look(route.path[i], ahead.normalized());
            last = route.path[i];
            first = false;
        }
    }
    RouteFacts facts = survey.facts();
    if (facts.steepest.value == 0.0) {
        facts.steepest.at = route.path.front();  // all of it is level
    }
    return facts;
}

}  // namespace campuswalk::engine
