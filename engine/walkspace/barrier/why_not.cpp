#include "engine/walkspace/barrier/why_not.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "collision/world/obstacle.h"
#include "engine/walkspace/barrier/abilities.h"
#include "engine/walkspace/barrier/smallest_change.h"
#include "engine/walkspace/stride/opposing_contact.h"
#include "engine/walkspace/stride/partial_world.h"
#include "engine/walkspace/stride/removable_nodes.h"

namespace campuswalk::engine {

using collision::ObjectId;
using collision::Obstacle;
using collision::Vec3;

namespace {

/// A local search that has reached this many cells has found no barrier, but another place.
constexpr std::size_t kMostNodes = 4'000;
/// Once the searches for one barrier have reached so many, no other change is tried: what is closed off for
/// good would take minutes.
constexpr std::size_t kMostNodesInAll = 50'000;
/// Objects that are taken away for a try, the nearest to where the body stopped first.
constexpr std::size_t kMostObjects = 12;
/// As much of the world is copied for that around where ways are looked for, metres.
constexpr double kAroundSearch = 2.0;
/// How far around the way that was found the exact number is looked for, metres.
constexpr double kAround = 1.5;
bool is_about_size(const Ability& ability) {
    return ability.kind == BarrierKind::opening || ability.kind == BarrierKind::headroom;
}

/// A way that a changed body found.
struct FoundPath {
    GroundState start;       ///< where it left what the body reaches
    std::vector<Vec3> feet;  ///< from there on
    double length = 0.0;     ///< of that, metres
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
        // The query speaks of these cells.
        settings_.grid = query.known.empty() ? WalkGrid() : query.known.front()->grid;
        settings_.max_nodes = std::min(settings.max_nodes, kMostNodes);
        settings_.max_ticks = static_cast<std::uint32_t>(
            query.longest_crossing / settings.strides.walk_speed / settings.strides.seconds);
        settings_.keep_rim = false;
        settings_.progress = {};
        settings_.solids.disabled = &disabled_;
    }

    std::optional<Barrier> run() {
        const collision::MoverSettings& body = settings_.strides.body;
        settings_.steer_falls = query_.steer_falls;
        if (find_path(body, query_.from)) {
            return std::nullopt;
        }
        settings_.steer_falls = false;  // by a changed body, that would be no barrier
        if (query_.changes == Changes::climbs) {
            return try_body(body, {climbs_of(body)});
        }
        if (query_.changes == Changes::body) {
            const auto barrier = try_body(body, {climbs_of(body), sizes_of(body)});
            return barrier ? barrier : closed_off();
        }
        const std::vector<ObjectId> touched = touched_;
        const std::vector<Ability> abilities = abilities_of(body);
        std::vector<Change> found;
        // As slim and as low as can be: where there is another way and that doesn't get there, neither is
        // tried by itself. It might be enough, as a slim body falls into gaps that others walk over.
        std::optional<bool> fits_nowhere;
        for (const Ability& ability : abilities) {
            if (is_about_size(ability) && !found.empty()) {
                if (!fits_nowhere) {
                    fits_nowhere = !is_exhausted() && !find_path(easiest_of(sizes_of(body)), query_.from);
                }
                if (*fits_nowhere) {
                    continue;
                }
            }
            if (auto barrier = try_ability(ability, body)) {
                found.push_back({std::move(*barrier)});
            }
        }
        try_objects(touched, found);
        if (std::ranges::none_of(found, is_small_climb)) {
            try_nodes(kSmallNode, found);
        }
        if (!found.empty()) {
            return smallest_of(std::move(found));
        }
        if (query_.changes == Changes::single) {
            return closed_off();
        }
        if (auto several = several_changes(abilities)) {
            return several;
        }
        try_nodes(std::numeric_limits<double>::infinity(), found);  // whole walls, if nothing else helps
        return found.empty() ? closed_off() : smallest_of(std::move(found));
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
        const WalkSpace space = explore(worlds, settings, UntilCell{query_.is_beyond});
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
        FoundPath path{chain.front().at, {}, length_of(chain)};
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
        if (is_exhausted()) {
            return std::nullopt;
        }
        const bool is_guessed = ability.kind == BarrierKind::riser && query_.likely_riser;
        const double likely = query_.likely_riser.value_or(0.0) - collision::kHeightSlack;
        double fails = ability.have;
        double passes = ability.easier.back();
        std::optional<FoundPath> path;
        if (is_guessed && likely + ability.precision > fails && likely + ability.precision < passes) {
            path = find_path(with(likely + ability.precision), query_.from);
            (path ? passes : fails) = likely + ability.precision;
        }
        if (!path) {
            path = find_path(with(ability.easier.back()), query_.from);
        }
        if (!path) {
            return std::nullopt;
        }
        const auto probe = [&](double value, std::span<const GroundState> from) {
            if (value <= std::min(fails, passes) || value >= std::max(fails, passes)) {
                return;
            }
            if (auto harder = find_path(with(value), from)) {
                passes = value;
                path = std::move(harder);
            } else {
                fails = value;
            }
        };
        if (is_guessed) {
            probe(likely - ability.precision, query_.from);
        }
        for (std::span<const double> steps = ability.easier; !steps.empty();) {
            const double middle = steps[steps.size() / 2];
            probe(middle, query_.from);
            const bool too_little = std::abs(middle - ability.have) <= std::abs(fails - ability.have);
            steps = too_little ? steps.subspan(steps.size() / 2 + 1) : steps.first(steps.size() / 2);
        }
        const std::vector<GroundState> near = starts_near(path->start.foot);
        while (std::abs(passes - fails) > ability.precision) {
            probe(0.5 * (passes + fails), near);
        }
        return measured(ability, passes, body, *path);
    }

    /// Steps up to kHighestRiser, and slopes.
    static std::vector<Ability> climbs_of(const collision::MoverSettings& body) {
        std::vector<Ability> abilities = abilities_of(body);
        for (Ability& ability : abilities) {
            if (ability.kind == BarrierKind::riser) {
                std::erase_if(ability.easier, [](double height) { return height > kHighestRiser; });
            }
        }
        std::erase_if(abilities, [](const Ability& ability) {
            return is_about_size(ability) || ability.easier.empty();
        });
        return abilities;
    }

    static std::vector<Ability> sizes_of(const collision::MoverSettings& body) {
        std::vector<Ability> abilities = abilities_of(body);
        std::erase_if(abilities, [](const Ability& ability) { return !is_about_size(ability); });
        return abilities;
    }

    /// None if nothing helps. Of those of one kind, none is tried by itself if they don't help together.
    std::optional<Barrier> try_body(const collision::MoverSettings& body,
                                    const std::vector<std::vector<Ability>>& kinds) {
        std::vector<Change> found;
        for (const std::vector<Ability>& abilities : kinds) {
            if (!find_path(easiest_of(abilities), query_.from)) {
                continue;
            }
            for (const Ability& ability : abilities) {
                if (auto barrier = try_ability(ability, body)) {
                    found.push_back({std::move(*barrier)});
                }
            }
        }
        return found.empty() ? std::nullopt : std::optional(smallest_of(std::move(found)));
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
    void try_objects(std::vector<ObjectId> touched, std::vector<Change>& found) {
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
                found.push_back({barrier, size_of(id), whole_length(*path)});
            }
        }
    }

    /// Nodes near the starts, no larger than this: without which of them would there be a way?
    void try_nodes(double largest, std::vector<Change>& found) {
        if (query_.nodes == nullptr) {
            return;
        }
        const collision::MoverSettings& body = settings_.strides.body;
        const collision::Aabb around = query_.within.grown(kAroundSearch);
        for (const RemovableNode& node :
             removable_nodes(worlds_[0], settings_.solids, body, *query_.nodes, query_.from, largest)) {
            const auto without = world_without(worlds_[0], node.object, node.triangles, around);
            if (without == nullptr || is_exhausted()) {
                continue;
            }
            if (const auto path = find_path_in(WorkerWorlds(*without, 1, {}), body, query_.from)) {
                Barrier barrier;
                barrier.kind = BarrierKind::object;
                locate(*path, body, barrier);
                if (barrier.object != node.object || !node.triangles.contains(barrier.triangle)) {
                    barrier.at = node.at;
                }
                barrier.object = node.object;
                barrier.triangle = node.triangle;
                barrier.is_node = true;
                // The node says more than the object that it is part of.
                std::erase_if(found, [&](const Change& change) {
                    return change.barrier.kind == BarrierKind::object && change.barrier.object == node.object;
                });
                found.push_back({barrier, size_of(node.object), whole_length(*path)});
                return;
            }
        }
    }

    /// From where the body was put down to the middle of what is beyond, straight on from where one gets
    /// there, metres: without a part of a wall near the door, the way as far as the wall may be shorter, but
    /// hardly the one into the room.
    double whole_length(const FoundPath& path) const {
        double length = path.length;
        if (query_.middle) {
            length += collision::horizontal_norm(*query_.middle - path.feet.back());
        }
        if (!query_.known.empty()) {
            const WalkSpace& reached = *query_.known.front();
            const Vec3& foot = path.start.foot;
            const auto node = reached.find(reached.grid.cell_at(foot), foot.y());
            length += node ? reached.length_to(*node) : 0.0;
        }
        return length;
    }

    double size_of(ObjectId id) const {
        const collision::Aabb& box = worlds_[0].bounds(id);
        return (box.max - box.min).norm();
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
            return carries(at, collision::closest({center, center}, piece), radius);
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

    /// Where no single change is enough.
    std::optional<Barrier> several_changes(const std::vector<Ability>& abilities) {
        if (is_exhausted() || (query_.is_enclosed && query_.is_enclosed())) {
            return std::nullopt;
        }
        const std::optional<FoundPath> easiest = find_path(easiest_of(abilities), query_.from);
        return easiest ? std::optional(all_at_once(abilities, *easiest)) : std::nullopt;
    }

    /// There is a way with every ability at its easiest; now each is made as hard as the others allow.
    Barrier all_at_once(const std::vector<Ability>& abilities, FoundPath path) {
        Barrier barrier;
        barrier.kind = BarrierKind::several;
        std::vector<double> values;
        values.reserve(abilities.size());
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

bool is_one_change(BarrierKind kind) {
    switch (kind) {
        case BarrierKind::riser:
        case BarrierKind::slope:
        case BarrierKind::opening:
        case BarrierKind::headroom:
        case BarrierKind::object:
            return true;
        default:
            return false;
    }
}

std::optional<Barrier> why_not(const WorkerWorlds& worlds, const ExploreSettings& settings,
                               const PassageQuery& query) {
    return Search(worlds, settings, query).run();
}

}  // namespace campuswalk::engine
