#include "engine/walkspace/why_not.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "collision/geometry/trigonometry.h"
#include "collision/mesh/mesh_collider.h"
#include "collision/world/obstacle.h"
#include "engine/walkspace/partial_world.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::Obstacle;
using collision::Vec3;

namespace {

constexpr double kDegree = 0.017453292519943295;
/// A local search that has reached this many cells has found no barrier, but another place.
constexpr std::size_t kMostNodes = 4'000;
/// Once the searches for one barrier have reached so many, no other change is tried: what is closed off for
/// good would take minutes.
constexpr std::size_t kMostNodesInAll = 50'000;
/// Objects that are taken away for a try, the nearest to where the body stopped first.
constexpr std::size_t kMostObjects = 12;
/// Nodes of larger meshes that are taken away for a try, the nearest to a start first, if they are this near
/// to a body that stands there, metres.
constexpr std::size_t kMostNodesTaken = 6;
constexpr double kNearNode = 0.4;
/// The diagonal of their bounds: a door or a bench, but no wall of a building, metres.
constexpr double kLargestNode = 5.0;
/// As much of the world is copied for that around where ways are looked for, metres.
constexpr double kAroundSearch = 2.0;
/// How far around the way that was found the exact number is looked for, metres.
constexpr double kAround = 1.5;
/// The skin of a body that an opening's width is measured with, metres.
constexpr double kThinSkin = 0.002;
/// Taking an object away counts as much as changing the body by this share, or climbing so much higher,
/// metres.
constexpr double kChangeOfObject = 0.6;

/// One ability of the body: what it has, and values that make it easier step by step.
struct Ability {
    BarrierKind kind;
    double have;
    std::vector<double> easier;
    double precision;
    void (*apply)(double value, collision::MoverSettings& body);
};

std::vector<Ability> abilities_of(const collision::MoverSettings& body) {
    const double slope = collision::angle_of(std::sqrt(1.0 - body.min_up * body.min_up), body.min_up);
    std::vector<Ability> all{
        {BarrierKind::riser,
         body.step_height,
         {0.35, 0.4, 0.5, 0.6, 0.8, 1.1, 1.5, 2.2, kHighestLedge},
         0.0005,
         [](double value, collision::MoverSettings& b) { b.step_height = value; }},
        {BarrierKind::slope,
         slope,
         {},
         0.05 * kDegree,
         [](double value, collision::MoverSettings& b) { b.min_up = collision::sin_cos(value).cos; }},
        {BarrierKind::opening,
         2.0 * body.radius,
         {},
         0.0005,
         [](double value, collision::MoverSettings& b) {
             b.radius = 0.5 * value;
             b.skin = std::min(b.skin, kThinSkin);  // or the opening would seem narrower by the skin
         }},
        {BarrierKind::headroom,
         body.height,
         {},
         0.0005,
         [](double value, collision::MoverSettings& b) {
             b.height = value;
             b.radius = std::min(b.radius, 0.5 * value);
         }},
    };
    for (const double degrees : {50.0, 55.0, 60.0, 65.0, 70.0, 75.0, 80.0}) {
        all[1].easier.push_back(degrees * kDegree);
    }
    for (const double share : {0.93, 0.8, 0.65, 0.5, 0.33, 0.2}) {
        all[2].easier.push_back(share * all[2].have);
    }
    for (const double share : {0.95, 0.85, 0.7, 0.55, 0.4, 0.3}) {
        all[3].easier.push_back(share * body.height);
    }
    for (Ability& ability : all) {
        const bool grows = ability.easier.back() > ability.easier.front();
        std::erase_if(ability.easier,
                      [&](double v) { return grows ? v <= ability.have : v >= ability.have; });
    }
    std::erase_if(all, [](const Ability& ability) { return ability.easier.empty(); });
    return all;
}

bool is_about_height(const Barrier& barrier) {
    return barrier.kind == BarrierKind::riser || barrier.kind == BarrierKind::ledge ||
           barrier.kind == BarrierKind::slope;
}

/// How much would have to change: of heights, in metres; else the share of what the body has.
double change_of(const Barrier& barrier) {
    const bool climb = barrier.kind == BarrierKind::riser || barrier.kind == BarrierKind::ledge;
    return barrier.kind == BarrierKind::object
               ? kChangeOfObject
               : std::abs(barrier.measured - barrier.allowed) / (climb ? 1.0 : barrier.allowed);
}

/// A way that a changed body found.
struct FoundPath {
    GroundState start;                   ///< where it left what the body reaches
    std::vector<Vec3> feet;              ///< from there on
    std::vector<ObjectId> touched = {};  ///< on all ways that were tried
};

class Search {
public:
    Search(const WorkerWorlds& worlds, const ExploreSettings& settings, const PassageQuery& query)
        : worlds_(worlds), settings_(settings), query_(query), disabled_(worlds[0].size(), false) {
        if (settings.solids.disabled != nullptr) {
            disabled_ = *settings.solids.disabled;
        }
        settings_.starts.clear();
        settings_.within = query.within;
        settings_.known = query.known;
        settings_.is_goal = query.is_beyond;
        settings_.max_nodes = std::min(settings.max_nodes, kMostNodes);
        settings_.keep_cell = true;  // the query speaks of these cells
        settings_.keep_rim = false;
        settings_.progress = {};
        settings_.solids.disabled = &disabled_;
    }

    std::optional<Barrier> run() {
        const collision::MoverSettings& body = settings_.strides.body;
        if (find_path(body, query_.from)) {
            return std::nullopt;
        }
        const std::vector<ObjectId> touched = touched_;
        const std::vector<Ability> abilities = abilities_of(body);
        std::vector<Barrier> found;
        for (const Ability& ability : abilities) {
            if (auto barrier = try_ability(ability, body)) {
                found.push_back(std::move(*barrier));
            }
        }
        try_objects(touched, found);
        if (std::ranges::none_of(found, is_about_height)) {
            try_nodes(found);
        }
        if (found.empty() && (query_.single_change || is_exhausted())) {
            return closed_off();
        }
        if (found.empty()) {
            const std::optional<FoundPath> easiest = find_path(easiest_of(abilities), query_.from);
            return easiest ? all_at_once(abilities, *easiest) : closed_off();
        }
        std::ranges::stable_sort(found, {}, change_of);
        Barrier smallest = found.front();
        smallest.parts.assign(found.begin() + 1, found.end());
        return smallest;
    }

private:
    std::optional<FoundPath> find_path(const collision::MoverSettings& body,
                                       std::span<const GroundState> from) {
        return find_path_in(worlds_, body, from);
    }

    std::optional<FoundPath> find_path_in(const WorkerWorlds& worlds, const collision::MoverSettings& body,
                                          std::span<const GroundState> from) {
        ExploreSettings settings = settings_;
        settings.strides.body = body;
        settings.more_starts.assign(from.begin(), from.end());
        const WalkSpace space = explore(worlds, settings);
        nodes_in_all_ += space.node_count();
        touched_.clear();
        for (std::size_t i = 0; i < space.touched.size(); ++i) {
            if (space.touched[i]) {
                touched_.push_back(static_cast<ObjectId>(i));
            }
        }
        if (!space.goal) {
            return std::nullopt;
        }
        Strider strider(worlds[0], settings.strides, settings.solids);
        const std::vector<ChainLink> chain = space.chain(*space.goal, strider);
        FoundPath path{chain.front().at, {}};
        for (const ChainLink& link : chain) {
            path.feet.push_back(link.at.foot);
        }
        return path;
    }

    bool is_exhausted() const { return nodes_in_all_ > kMostNodesInAll; }

    /// The starts near the one that led to a way.
    std::vector<GroundState> starts_near(const Vec3& place) const {
        std::vector<GroundState> near;
        for (const GroundState& at : query_.from) {
            if (collision::horizontal_norm(at.foot - place) <= kAround) {
                near.push_back(at);
            }
        }
        return near;
    }

    std::optional<Barrier> try_ability(const Ability& ability, const collision::MoverSettings& body) {
        const auto with = [&](double value) {
            collision::MoverSettings changed = body;
            ability.apply(value, changed);
            return changed;
        };
        if (is_exhausted() || !find_path(with(ability.easier.back()), query_.from)) {
            return std::nullopt;
        }
        double fails = ability.have;
        double passes = ability.easier.back();
        std::optional<FoundPath> path;
        for (const double value : ability.easier) {
            path = find_path(with(value), query_.from);
            if (path) {
                passes = value;
                break;
            }
            fails = value;
        }
        if (!path) {
            return std::nullopt;  // what one more start would do, another's chain may not
        }
        const std::vector<GroundState> near = starts_near(path->start.foot);
        while (std::abs(passes - fails) > ability.precision) {
            const double middle = 0.5 * (passes + fails);
            if (auto nearer = find_path(with(middle), near)) {
                passes = middle;
                path = std::move(nearer);
            } else {
                fails = middle;
            }
        }
        return measured(ability, passes, body, *path);
    }

    Barrier measured(const Ability& ability, double value, const collision::MoverSettings& body,
                     const FoundPath& path) const {
        Barrier barrier;
        barrier.kind = ability.kind;
        barrier.measured = value;
        barrier.allowed = ability.have;
        if (ability.kind == BarrierKind::riser) {
            barrier.measured += collision::kHeightSlack;
            barrier.kind = barrier.measured > kHighestRiser ? BarrierKind::ledge : BarrierKind::riser;
        }
        locate(path, body, barrier);
        return barrier;
    }

    /// Sends the body along the way of the changed one: what it is stopped by is the barrier.
    void locate(const FoundPath& path, const collision::MoverSettings& body, Barrier& barrier) const {
        StrideSettings strides = settings_.strides;
        strides.body = body;
        Strider strider(worlds_[0], strides, settings_.solids);
        GroundState at = path.start;
        Vec3 ahead = Vec3::Zero();
        for (std::size_t i = 1; i < path.feet.size(); ++i) {
            const StrideEnd end = strider.walk_to(at, path.feet[i], 0.02, 1.0);
            ahead = path.feet[i] - end.at.foot;
            ahead.y() = 0.0;
            if (end.kind != StrideEnd::Kind::grounded) {
                break;
            }
            at = end.at;
            if (ahead.norm() > 0.05 || std::abs(path.feet[i].y() - at.foot.y()) > body.step_height) {
                break;
            }
        }
        barrier.from = at.foot;
        barrier.at = at.foot;
        if (const auto contact = opposing_contact(worlds_[0], settings_.solids, body, at.foot, ahead)) {
            barrier.object = contact->object;
            barrier.triangle = contact->triangle;
            barrier.at = contact->at;
        }
    }

    /// Objects that the body touched but that don't carry it: without which of them would there be a way?
    void try_objects(std::vector<ObjectId> touched, std::vector<Barrier>& found) {
        const collision::MoverSettings& body = settings_.strides.body;
        const Vec3 center = query_.within.center();
        const auto distance = [&](ObjectId id) {
            return (worlds_[0].bounds(id).center() - center).squaredNorm();
        };
        std::ranges::stable_sort(touched, {}, distance);
        std::size_t tried = 0;
        for (const ObjectId id : touched) {
            if (is_exhausted() || carries_a_start(id) || tried == kMostObjects) {
                continue;
            }
            ++tried;
            disabled_[index_of(id)] = true;
            const auto path = find_path(body, query_.from);
            disabled_[index_of(id)] = false;
            if (path) {
                Barrier barrier;
                barrier.kind = BarrierKind::object;
                locate(*path, body, barrier);
                barrier.object = id;
                found.push_back(barrier);
            }
        }
    }

    /// A node that is part of an object's mesh, and where it is nearest to a start.
    struct NearNode {
        Obstacle piece;
        scene::TriangleRange triangles;
        double distance = 0.0;
        Vec3 at = Vec3::Zero();
    };

    /// Nodes near the starts: without which of them would there be a way? A door rather than a wall, so the
    /// smallest first.
    void try_nodes(std::vector<Barrier>& found) {
        const collision::MoverSettings& body = settings_.strides.body;
        const collision::Aabb around = query_.within.grown(kAroundSearch);
        std::vector<NearNode> near = nodes_near_starts();
        std::erase_if(near, [&](const NearNode& node) { return size_of(node) > kLargestNode; });
        near.resize(std::min(near.size(), kMostNodesTaken));
        std::ranges::stable_sort(near, {}, [&](const NearNode& node) { return size_of(node); });
        for (const NearNode& node : near) {
            const auto without = world_without(worlds_[0], node.piece.object, node.triangles, around);
            if (without == nullptr || is_exhausted()) {
                continue;
            }
            const auto path = find_path_in(WorkerWorlds(*without, 1, {}), body, query_.from);
            if (path) {
                Barrier barrier;
                barrier.kind = BarrierKind::object;
                locate(*path, body, barrier);
                if (barrier.object != node.piece.object || !node.triangles.contains(barrier.triangle)) {
                    barrier.at = node.at;
                }
                barrier.object = node.piece.object;
                barrier.triangle = node.piece.triangle;
                found.push_back(barrier);
                return;
            }
        }
    }

    /// The diagonal of its bounds.
    double size_of(const NearNode& node) const {
        const auto& shape = worlds_[0].object(node.piece.object).shape;
        const auto& mesh = std::get<std::shared_ptr<const collision::MeshCollider>>(shape)->mesh();
        collision::Aabb bounds;
        for (std::uint32_t t = node.triangles.first; t < node.triangles.end; ++t) {
            const collision::Triangle triangle = collision::vertices(mesh, t);
            bounds.extend(triangle.a);
            bounds.extend(triangle.b);
            bounds.extend(triangle.c);
        }
        return (bounds.max - bounds.min).norm();
    }

    /// The nearest first, without those that carry a start.
    std::vector<NearNode> nodes_near_starts() const {
        std::vector<NearNode> nodes;
        if (query_.nodes == nullptr) {
            return nodes;
        }
        const collision::MoverSettings& body = settings_.strides.body;
        std::vector<NearNode> grounds;
        std::vector<Obstacle> near;
        for (const GroundState& at : query_.from) {
            const collision::Segment core = body.core(at.foot);
            collision::gather_obstacles(worlds_[0], settings_.solids, core, body.radius + kNearNode, near);
            for (const Obstacle& piece : near) {
                const auto triangles = query_.nodes->of_same_node(piece.object, piece.triangle);
                if (!triangles) {
                    continue;
                }
                const collision::Closest c = collision::closest(core, piece);
                const NearNode node{piece, *triangles, c.distance, c.on_shape};
                keep_nearest(carries(at, c) ? grounds : nodes, node);
            }
        }
        std::erase_if(nodes, [&](const NearNode& node) {
            return std::ranges::any_of(grounds,
                                       [&](const NearNode& ground) { return is_same(node, ground); });
        });
        std::ranges::stable_sort(nodes, {}, &NearNode::distance);
        return nodes;
    }

    static bool is_same(const NearNode& a, const NearNode& b) {
        return a.piece.object == b.piece.object && a.triangles == b.triangles;
    }

    static void keep_nearest(std::vector<NearNode>& nodes, const NearNode& node) {
        const auto known =
            std::ranges::find_if(nodes, [&](const NearNode& other) { return is_same(other, node); });
        if (known == nodes.end()) {
            nodes.push_back(node);
        } else if (node.distance < known->distance) {
            *known = node;
        }
    }

    /// Whether a body that stands there is carried by what it is nearest to in `c`.
    bool carries(const GroundState& at, const collision::Closest& c) const {
        constexpr double kTouching = 0.01;
        const double radius = settings_.strides.body.radius;
        return c.distance <= radius + kTouching && c.on_shape.y() <= at.foot.y() + 0.3 * radius;
    }

    /// Taking away the ground is no change that helps.
    bool carries_a_start(ObjectId id) const {
        const collision::Aabb& box = worlds_[0].bounds(id);
        return std::ranges::any_of(query_.from, [&](const GroundState& at) {
            const Vec3 below = at.foot - Vec3(0, 0.02, 0);
            return (below.array() >= box.min.array() - 0.01).all() &&
                   (below.array() <= box.max.array() + 0.01).all() && at.support_y <= box.max.y() + 0.01 &&
                   supports(id, at);
        });
    }

    bool supports(ObjectId id, const GroundState& at) const {
        const double radius = settings_.strides.body.radius;
        const Vec3 center = at.foot + Vec3(0, radius, 0);
        std::vector<Obstacle> near;
        collision::gather_pieces(worlds_[0], id, {center, center}, radius + 0.01, near);
        return std::ranges::any_of(near, [&](const Obstacle& piece) {
            return carries(at, collision::closest({center, center}, piece));
        });
    }

    collision::MoverSettings easiest_of(const std::vector<Ability>& abilities) const {
        collision::MoverSettings easiest = settings_.strides.body;
        for (const Ability& ability : abilities) {
            ability.apply(ability.easier.back(), easiest);
        }
        return easiest;
    }

    Barrier closed_off() const {
        Barrier barrier;
        barrier.from = query_.from.empty() ? Vec3(Vec3::Zero()) : query_.from.front().foot;
        barrier.at = barrier.from;
        return barrier;
    }

    /// There is a way with every ability at its easiest; now each is made as hard as the others allow.
    Barrier all_at_once(const std::vector<Ability>& abilities, FoundPath path) {
        Barrier barrier;
        barrier.kind = BarrierKind::several;
        std::vector<double> values;
        for (const Ability& ability : abilities) {
            values.push_back(ability.easier.back());
        }
        for (std::size_t i = 0; i < abilities.size(); ++i) {
            harden(abilities, i, values);
        }
        collision::MoverSettings needed = settings_.strides.body;
        for (std::size_t i = 0; i < abilities.size(); ++i) {
            abilities[i].apply(values[i], needed);
        }
        if (auto exact = find_path(needed, query_.from)) {
            path = std::move(*exact);
        }
        for (std::size_t i = 0; i < abilities.size(); ++i) {
            if (values[i] != abilities[i].have) {
                barrier.parts.push_back(measured(abilities[i], values[i], settings_.strides.body, path));
            }
        }
        locate(path, settings_.strides.body, barrier);
        return barrier;
    }

    void harden(const std::vector<Ability>& abilities, std::size_t which, std::vector<double>& values) {
        const auto passes_with = [&](double value) {
            collision::MoverSettings body = settings_.strides.body;
            for (std::size_t i = 0; i < abilities.size(); ++i) {
                abilities[i].apply(i == which ? value : values[i], body);
            }
            return find_path(body, query_.from).has_value();
        };
        const Ability& ability = abilities[which];
        double fails = ability.have;
        double passes = values[which];
        if (passes_with(fails)) {
            values[which] = fails;
            return;
        }
        while (std::abs(passes - fails) > ability.precision) {
            const double middle = 0.5 * (passes + fails);
            (passes_with(middle) ? passes : fails) = middle;
        }
        values[which] = passes;
    }

    const WorkerWorlds& worlds_;
    ExploreSettings settings_;
    const PassageQuery& query_;
    std::vector<bool> disabled_;
    std::vector<ObjectId> touched_;  ///< by the last search
    std::size_t nodes_in_all_ = 0;
};

}  // namespace

std::optional<OpposingContact> opposing_contact(const collision::World& world,
                                                const collision::QueryFilter& solids,
                                                const collision::MoverSettings& body, const Vec3& foot,
                                                const Vec3& ahead) {
    constexpr double kReach = 0.05;
    constexpr double kLeast = 0.1;  // of the cosine between the contact and the move
    const collision::Segment core = body.core(foot);
    std::vector<Obstacle> near;
    collision::gather_obstacles(world, solids, core, body.radius + body.skin + kReach, near);
    std::optional<OpposingContact> contact;
    double strongest = kLeast;
    for (const Obstacle& piece : near) {
        const collision::Closest c = collision::closest(core, piece);
        Vec3 towards = c.on_shape - c.on_segment;
        towards.y() = 0.0;
        const double lengths = towards.norm() * ahead.norm();
        const double against = lengths > 0.0 ? towards.dot(ahead) / lengths : 0.0;
        if (against > strongest) {
            strongest = against;
            contact = OpposingContact{piece.object, piece.triangle, c.on_shape};
        }
    }
    return contact;
}

std::optional<Barrier> why_not(const WorkerWorlds& worlds, const ExploreSettings& settings,
                               const PassageQuery& query) {
    return Search(worlds, settings, query).run();
}

}  // namespace campuswalk::engine
