#include "engine/walkspace/report/subjects.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <utility>
#include <variant>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/cast.h"
#include "collision/world/obstacle.h"
#include "collision/world/overlap_span.h"
#include "collision/world/placement.h"
#include "engine/walkspace/barrier/place_check.h"
#include "engine/walkspace/space/reach_point.h"

namespace campuswalk::engine {

using collision::Aabb;
using collision::Detection;
using collision::ObjectId;
using collision::Vec3;

namespace {

/// A body is at most this far from the middle of its node's cell, as a share of the cell.
constexpr double kOffCenter = 0.71;
/// Nodes whose exact state is computed to test one object, the nearest to its middle first.
constexpr std::size_t kMostExact = 64;
/// Nodes, and points of an object, between which lines of sight are tried.
constexpr std::size_t kMostEyes = 256;
constexpr std::size_t kMostPoints = 24;

/// The object's middle and some of its triangles' middles.
std::vector<Vec3> points_of(const collision::World& world, ObjectId id) {
    const collision::Object& object = world.object(id);
    std::vector<Vec3> points{world.bounds(id).center()};
    if (const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape)) {
        const collision::TriangleMesh& shape = (*mesh)->mesh();
        const std::size_t every = std::max<std::size_t>(1, shape.triangles.size() / kMostPoints);
        for (std::size_t i = 0; i < shape.triangles.size(); i += every) {
            Vec3 sum = Vec3::Zero();
            for (const std::uint32_t vertex : shape.triangles[i]) {
                sum += shape.positions[vertex].cast<double>();
            }
            points.push_back(object.X_world_shape * Vec3(sum / 3.0));
        }
    }
    return points;
}

class Finder {
public:
    explicit Finder(const SubjectSearch& search)
        : s_(search),
          world_(search.campus.world),
          body_(search.settings.strides.body),
          upright_(search.settings.strides.upright_body()),
          strider_(search.worlds[0], search.settings.strides, search.settings.solids) {}

    std::vector<Subject> run() {
        const scene::CampusDescription& description = s_.campus.description;
        for (const scene::Spawn& spawn : description.spawns) {
            add_point(SubjectKind::spawn, spawn.name, spawn.position, true);
        }
        for (const scene::Place& place : description.places) {
            add_point(SubjectKind::place, place.name, place.position, place.has_height);
        }
        const std::size_t first_building = subjects_.size();
        for (const scene::Building& building : description.buildings) {
            subjects_.push_back({SubjectKind::building, building.id});
        }
        for (std::size_t i = 0; i < s_.campus.objects.size(); ++i) {
            if (is_noticed(static_cast<ObjectId>(i))) {
                add_object(static_cast<ObjectId>(i), first_building);
            }
        }
        std::ranges::move(find_doors(s_), std::back_inserter(subjects_));
        return std::move(subjects_);
    }

private:
    void add_point(SubjectKind kind, const std::string& name, const Vec3& at, bool has_height) {
        Subject subject{kind, name};
        subject.at = at;
        const PointReach reach = reach_point(s_.reached, strider_, at, has_height);
        if (reach.node) {
            subject.reached = true;
            subject.node = reach.node;
            subject.at.y() = has_height ? at.y() : reach.foot.y();
        } else {
            explain_point(subject, reach.nearest);
        }
        subjects_.push_back(std::move(subject));
    }

    /// `nearest`: how near to it one gets.
    void explain_point(Subject& subject, double nearest) {
        const PlaceCheck place = check_place(s_.campus, strider_, subject.at);
        if (!place.ground) {
            subject.reason = place.problem;
            return;
        }
        subject.island = island_at(place.ground->foot);
        if (!subject.island && s_.reached.is_cut_by(Bound::nodes)) {
            subject.reason = {.kind = ReasonKind::unsearched};
        } else if (!subject.island) {
            subject.reason = {.kind = ReasonKind::no_nearer};
            if (nearest <= 1.0) {
                subject.reason->measured = nearest;
                subject.reason->object = object_at(subject.at);
            }
        }
    }

    /// What a body at the place would overlap; empty if nothing.
    std::string object_at(const Vec3& at) const {
        const auto object = collision::obstruction(world_, s_.settings.solids, at + Vec3(0, 0.02, 0),
                                                   body_.radius, body_.height);
        return object ? s_.campus.objects[index_of(*object)].id : "";
    }

    std::optional<std::size_t> island_at(const Vec3& foot) const {
        std::optional<std::size_t> nearest;
        double least = 0.8;
        for (std::size_t i = 0; i < s_.islands.size(); ++i) {
            const Aabb& box = s_.islands[i].bounds;
            if (!box.grown(least).overlaps({foot, foot})) {
                continue;
            }
            for (const UnreachedSpot& spot : s_.islands[i].spots) {
                if (const double apart = (spot.at.foot - foot).norm(); apart < least) {
                    least = apart;
                    nearest = i;
                }
            }
        }
        return nearest;
    }

    bool is_noticed(ObjectId id) const {
        const collision::QueryFilter& filter = s_.settings.solids;
        return (filter.disabled == nullptr || !(*filter.disabled)[index_of(id)]) &&
               ((filter.ignored_layers >> world_.object(id).layer) & 1U) == 0;
    }

    void add_object(ObjectId id, std::size_t first_building) {
        const collision::Object& object = world_.object(id);
        const scene::CampusObject& named = s_.campus.objects[index_of(id)];
        const auto add = [&](SubjectKind kind, void (Finder::*find)(ObjectId, Subject&)) {
            Subject subject{kind, named.id};
            subject.at = world_.bounds(id).center();
            (this->*find)(id, subject);
            if (subject.reached && named.building && kind != SubjectKind::solid) {
                reach_building(subjects_[first_building + *named.building], subject);
            }
            if (subject.reached && named.building && kind == SubjectKind::solid &&
                s_.reached.touched[index_of(id)]) {
                reach_building(subjects_[first_building + *named.building], subject);
            }
            subjects_.push_back(std::move(subject));
        };
        if (collision::any_of(object.detection, Detection::trigger)) {
            add(SubjectKind::trigger, &Finder::find_trigger);
        }
        if (collision::any_of(object.detection, Detection::ray)) {
            add(SubjectKind::ray, &Finder::find_ray);
        }
        if (collision::any_of(object.detection, Detection::solid)) {
            add(SubjectKind::solid, &Finder::find_solid);
        }
    }

    static void reach_building(Subject& building, const Subject& by) {
        if (!building.reached) {
            building.reached = true;
            building.at = by.at;
            building.node = by.node;
        }
    }

    /// Nodes whose body may overlap the box, the nearest to its middle first.
    std::vector<WalkNodeId> nodes_near(const Aabb& box, std::size_t most) const {
        std::vector<std::pair<double, WalkNodeId>> near;
        for (const WalkNodeId& node : s_.reached.nodes_touching(box, upright_)) {
            near.emplace_back((s_.reached.position(node) - box.center()).squaredNorm(), node);
        }
        const auto end = near.begin() + static_cast<std::ptrdiff_t>(std::min(most, near.size()));
        std::ranges::partial_sort(near, end);
        std::vector<WalkNodeId> nodes;
        for (auto it = near.begin(); it != end; ++it) {
            nodes.push_back(it->second);
        }
        return nodes;
    }

    /// The body as it is at the node: upright where it has headroom.
    const collision::MoverSettings& body_at(const WalkNodeId& node) const {
        return s_.reached.node(node).low != 0 ? body_ : upright_;
    }

    void find_trigger(ObjectId id, Subject& subject) {
        const auto overlaps = [&](const WalkNodeId& node, const Vec3& foot, double slack) {
            return collision::overlap_span(world_, id, body_at(node).core(foot), body_.radius + slack,
                                           Vec3::Zero())
                .has_value();
        };
        std::size_t exact = 0;
        for (const WalkNodeId& node : nodes_near(world_.bounds(id), 1U << 20U)) {
            if (!overlaps(node, s_.reached.position(node), kOffCenter * s_.reached.grid.cell + 0.01)) {
                continue;
            }
            const Vec3 foot = s_.reached.state_at(node, strider_).foot;
            if (overlaps(node, foot, 0.0)) {
                subject.reached = true;
                subject.at = foot;
                subject.node = node;
                return;
            }
            if (++exact == kMostExact) {
                break;
            }
        }
        explain_trigger(id, subject);
    }

    void explain_trigger(ObjectId id, Subject& subject) const {
        const Aabb box = world_.bounds(id).grown(body_.radius);
        for (std::size_t i = 0; i < s_.islands.size(); ++i) {
            for (const UnreachedSpot& spot : s_.islands[i].spots) {
                if (box.overlaps({spot.at.foot, spot.at.foot + Vec3(0, body_.height, 0)}) &&
                    collision::overlap_span(world_, id, body_.core(spot.at.foot), body_.radius,
                                            Vec3::Zero())) {
                    subject.island = i;
                    subject.at = spot.at.foot;
                    return;
                }
            }
        }
        subject.reason = {.kind = ReasonKind::no_room};
    }

    void find_ray(ObjectId id, Subject& subject) {
        const double reach = s_.avatar.look_distance;
        const std::vector<Vec3> points = points_of(world_, id);
        const collision::QueryFilter filter{Detection::solid | Detection::ray,
                                            s_.settings.solids.ignored_layers, s_.settings.solids.disabled};
        const Aabb near = world_.bounds(id).grown(std::max(0.0, reach - body_.radius));
        const std::vector<WalkNodeId> eyes = nodes_near(near, 1U << 20U);
        const std::size_t every = std::max<std::size_t>(1, eyes.size() / kMostEyes);
        for (std::size_t i = 0; i < eyes.size(); i += every) {
            const double stature = body_at(eyes[i]).height / upright_.height;
            const Vec3 eye = s_.reached.position(eyes[i]) + Vec3(0, stature * s_.avatar.eye_height, 0);
            for (const Vec3& point : points) {
                const Vec3 path = point - eye;
                const double distance = path.norm();
                if (distance <= 0.0 || distance > reach) {
                    continue;
                }
                const collision::Ray ray{eye, eye + reach / distance * path};
                const auto hit = collision::cast(world_, filter, ray, Detection::ray);
                if (hit && hit->object == id) {
                    subject.reached = true;
                    subject.at = s_.reached.position(eyes[i]);
                    subject.node = eyes[i];
                    return;
                }
            }
        }
        subject.reason = eyes.empty() ? Reason{.kind = ReasonKind::no_nearer, .allowed = reach}
                                      : Reason{.kind = ReasonKind::contact};
    }

    void find_solid(ObjectId id, Subject& subject) {
        subject.reached = s_.reached.touched[index_of(id)] || carries_a_node(id);
        if (!subject.reached) {
            subject.reason = {.kind = ReasonKind::no_nearer};
        }
    }

    bool carries_a_node(ObjectId id) const {
        std::vector<collision::Obstacle> pieces;
        for (const WalkNodeId& node : nodes_near(world_.bounds(id), kMostEyes)) {
            const Vec3 center = s_.reached.position(node) + Vec3(0, body_.radius, 0);
            collision::gather_pieces(world_, id, {center, center}, body_.radius + 0.02, pieces);
            if (!pieces.empty()) {
                return true;
            }
        }
        return false;
    }

    const SubjectSearch& s_;
    const collision::World& world_;
    const collision::MoverSettings& body_;
    const collision::MoverSettings upright_;
    Strider strider_;
    std::vector<Subject> subjects_;
};

}  // namespace

std::vector<Subject> find_subjects(const SubjectSearch& search) {
    return Finder(search).run();
}

bool is_destination(SubjectKind kind) {
    return kind != SubjectKind::solid && kind != SubjectKind::door;
}

const char* name_of(SubjectKind kind) {
    return kSubjectKindNames.at(static_cast<std::size_t>(kind));
}

}  // namespace campuswalk::engine
