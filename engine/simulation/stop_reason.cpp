#include "engine/simulation/stop_reason.h"

#include <cmath>
#include <limits>
#include <vector>

#include "collision/world/obstacle.h"
#include "collision/world/placement.h"
#include "engine/walkspace/barrier/barrier_reason.h"
#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/stride/opposing_contact.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

// What counts as beyond the obstacle, from where the body was stopped, along its heading and beside that,
// metres: farther than a body is wide, near enough to be about this obstacle.
constexpr double kNearest = 0.7;
constexpr double kFarthest = 2.5;
constexpr double kBeside = 0.75;
/// Ways round are looked for this far about, and this high and low, metres.
constexpr double kAround = 3.0;
constexpr double kHeight = 3.2;
constexpr std::size_t kMostNodes = 1'500;

class StopQuery {
public:
    StopQuery(const scene::Campus& campus, const StoppedBody& body)
        : campus_(campus), body_(body), worlds_(campus.world, 1, {}), ahead_(body.heading.normalized()) {
        settings_.strides = body.strides;
        settings_.solids = body.solids;
        settings_.max_nodes = kMostNodes;
    }

    std::optional<Reason> reason() {
        PassageQuery query;
        query.from = {body_.at};
        query.is_beyond = [this](const GridCell& cell, double y) { return is_beyond(cell, y); };
        const Vec3 around(kAround, kHeight, kAround);
        query.within = {body_.at.foot - around, body_.at.foot + around};
        std::optional<Reason> contact = contact_reason();
        if (const auto round = path_round(query)) {
            if (contact) {
                contact->detour = round;
            }
            return contact;
        }
        const scene::NodeTriangles nodes(campus_, query.within);
        query.nodes = &nodes;
        query.changes = Changes::single;
        const auto barrier = barrier_in(why_not(worlds_, settings_, query));
        return !barrier || barrier->kind == ReasonKind::solid ? contact : reason_of(campus_, *barrier);
    }

private:
    bool is_beyond(const GridCell& cell, double y) const {
        Vec3 apart = grid_.center(cell) - body_.at.foot;
        apart.y() = 0.0;
        const double along = apart.dot(ahead_);
        const double beside = (apart - along * ahead_).norm();
        return along >= kNearest && along <= kFarthest && beside <= kBeside &&
               std::abs(y - body_.at.foot.y()) <= kHeight;
    }

    /// How far the body walks to get beyond what stops it, if it can.
    std::optional<double> path_round(const PassageQuery& query) {
        ExploreSettings settings = settings_;
        settings.more_starts = query.from;
        settings.within = query.within;
        const WalkSpace space = explore(worlds_, settings, UntilCell{query.is_beyond});
        if (!space.goal) {
            return std::nullopt;
        }
        Strider strider(campus_.world, settings.strides, settings.solids);
        return length_of(space.chain(*space.goal, strider));
    }

    std::optional<Reason> contact_reason() const {
        const auto contact =
            opposing_contact(campus_.world, body_.solids, body_.strides.body, body_.at.foot, ahead_);
        if (!contact) {
            return std::nullopt;
        }
        return reason_about(ReasonKind::contact, campus_, contact->object, contact->at);
    }

    const scene::Campus& campus_;
    const StoppedBody& body_;
    WorkerWorlds worlds_;
    Vec3 ahead_;
    WalkGrid grid_;
    ExploreSettings settings_;
};

/// Of the object that carries a body, what the body touches.
Vec3 carrying_point(const collision::World& world, collision::ObjectId object,
                    const collision::MoverSettings& body, const Vec3& foot) {
    const collision::Segment core = body.core(foot);
    std::vector<collision::Obstacle> pieces;
    collision::gather_pieces(world, object, core, body.radius, pieces);
    Vec3 point = foot;
    double least = std::numeric_limits<double>::max();
    for (const collision::Obstacle& piece : pieces) {
        if (const collision::Closest c = collision::closest(core, piece); c.distance < least) {
            least = c.distance;
            point = c.on_shape;
        }
    }
    return point;
}

}  // namespace

std::optional<Reason> reason_of_stop(const scene::Campus& campus, const StoppedBody& body) {
    return body.heading.isZero(0.0) ? std::nullopt : StopQuery(campus, body).reason();
}

std::optional<Reason> reason_of_fall(const scene::Campus& campus, const StoppedBody& stood) {
    constexpr double kInto = 0.02;  // metres: beside walls there is more room than below the feet
    const collision::MoverSettings& body = stood.strides.body;
    const Vec3 lowered = stood.at.foot - Vec3(0, kInto, 0);
    const auto carried_by =
        collision::obstruction(campus.world, stood.solids, lowered, body.radius, body.height);
    if (!carried_by) {
        return std::nullopt;
    }
    const Vec3 edge = carrying_point(campus.world, *carried_by, body, lowered);
    return reason_about(ReasonKind::edge, campus, *carried_by, edge);
}

}  // namespace campuswalk::engine
