#include "engine/walkspace/passage/trigger_overhangs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include <Eigen/Geometry>

#include "collision/geometry/disjoint_sets.h"
#include "collision/world/overlap_span.h"
#include "engine/walkspace/space/neighbour_joiner.h"

namespace campuswalk::engine {

using collision::Detection;
using collision::ObjectId;
using collision::Vec3;

namespace {

/// Nodes of one storey whose exact state is computed to test one trigger.
constexpr std::size_t kMostExactPerStorey = 64;
/// A body of which no more sticks out is wholly in a trigger, metres: feet on a bump, a trigger made by hand.
constexpr double kNotQuite = 0.1;
/// Bodies with no more difference are as much in it, metres.
constexpr double kSameCover = 0.05;
/// Neighbours that differ no more in height are level ground, metres.
constexpr double kLevel = 0.03;
/// A floor is larger than a tread: m², and metres for the body's middle.
constexpr double kLeastFloor = 1.0;
constexpr double kDeepestTread = 0.8;

class OverhangFinder {
public:
    OverhangFinder(const scene::Campus& campus, const WorkerWorlds& worlds, const ExploreSettings& settings,
                   const WalkSpace& space, const Storeys& storeys)
        : world_(campus.world),
          body_(settings.strides.upright_body()),
          space_(space),
          storeys_(storeys),
          strider_(worlds[0], settings.strides, settings.solids) {
        const collision::QueryFilter triggers{Detection::trigger, settings.solids.ignored_layers,
                                              settings.solids.disabled};
        world_.candidates(world_.bounds(), triggers, triggers_);
    }

    std::vector<TriggerOverhang> run() {
        std::vector<TriggerOverhang> found;
        for (const ObjectId trigger : triggers_) {
            std::map<std::size_t, std::vector<Entry>> by_storey;
            for (const Entry& entry : out_of_place(entries_of(trigger))) {
                by_storey[storeys_.of(entry.node)].push_back(entry);
            }
            for (auto& [storey, entries] : by_storey) {
                if (const auto foot = deepest_foot(trigger, entries)) {
                    found.push_back(overhang(trigger, storey, *foot));
                }
            }
        }
        return found;
    }

private:
    /// A node whose body is in a trigger.
    struct Entry {
        WalkNodeId node;
        GridCell cell;
        double y = 0.0;
        double covered = 0.0;  ///< so much of the body's height, metres
    };

    double covered(const collision::Aabb& bounds, double y) const {
        return std::min(bounds.max.y(), y + body_.height) - std::max(bounds.min.y(), y);
    }
    bool is_whole(double covered) const { return covered >= body_.height - kNotQuite; }

    /// Empty if all of them are wholly in it.
    std::vector<Entry> entries_of(ObjectId trigger) const {
        const collision::Aabb& bounds = world_.bounds(trigger);
        std::vector<Entry> entries;
        bool all_whole = true;
        for (const WalkNodeId& id : space_.nodes_touching(bounds, body_)) {
            const WalkNode& node = space_.node(id);
            const auto y = static_cast<double>(node.y);
            if (node.low == 0 && node.hangs == 0) {
                entries.push_back({id, space_.cell_of(id), y, covered(bounds, y)});
                all_whole = all_whole && is_whole(entries.back().covered);
            }
        }
        if (all_whole) {
            return {};
        }
        std::erase_if(entries, [&](const Entry& s) { return !is_in(trigger, space_.position(s.node)); });
        return entries;
    }

    /// Level ground.
    struct Floor {
        double area = 0.0;
        Eigen::AlignedBox2d bounds;

        void add(const GridCell& cell, double size) {
            area += size * size;
            bounds.extend(size * Eigen::Vector2d(cell.x, cell.z));
            bounds.extend(size * Eigen::Vector2d(cell.x + 1, cell.z + 1));
        }
        /// Wider than treads are deep.
        bool is_wide() const { return area >= kLeastFloor && bounds.sizes().minCoeff() > kDeepestTread; }
    };

    /// By cell, the entries of one trigger.
    using Columns = std::unordered_map<GridCell, std::vector<const Entry*>, GridCellHash>;

    static Columns columns_of(const std::vector<Entry>& entries) {
        Columns columns;
        for (const Entry& entry : entries) {
            columns[entry.cell].push_back(&entry);
        }
        return columns;
    }

    /// Whether the trigger goes on beyond the floor above or below, to where more of a body is in it.
    static bool goes_on(const Entry& entry, const Columns& columns) {
        return std::ranges::any_of(columns.at(entry.cell), [&](const Entry* other) {
            return std::abs(other->y - entry.y) >= kLeastStoreyHeight &&
                   other->covered > entry.covered + kSameCover;
        });
    }

    /// Those on ground that the trigger isn't made for.
    std::vector<Entry> out_of_place(const std::vector<Entry>& entries) const {
        const Columns columns = columns_of(entries);
        std::set<std::size_t> whole_storeys;
        for (const Entry& entry : entries) {
            if (is_whole(entry.covered)) {
                whole_storeys.insert(storeys_.of(entry.node));
            }
        }
        std::vector<std::size_t> suspects;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (!is_whole(entries[i].covered) &&
                (!whole_storeys.contains(storeys_.of(entries[i].node)) || goes_on(entries[i], columns))) {
                suspects.push_back(i);
            }
        }
        return suspects.empty() ? std::vector<Entry>() : out_of_place(entries, suspects, columns);
    }

    std::vector<Entry> out_of_place(const std::vector<Entry>& entries,
                                    const std::vector<std::size_t>& suspects, const Columns& columns) const {
        collision::DisjointSets grounds(entries.size());
        collision::DisjointSets floors(entries.size());
        NeighbourJoiner by_steps(grounds, body_.step_height + collision::kHeightSlack + WalkNode::kLevel);
        NeighbourJoiner level(floors, kLevel);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            by_steps.add(entries[i].cell, entries[i].y, i);
            level.add(entries[i].cell, entries[i].y, i);
        }
        const std::set<std::uint32_t> made_for = grounds_made_for(entries, grounds);
        std::set<std::size_t> own_storeys;
        std::map<std::uint32_t, Floor> by_floor;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            by_floor[floors.root(i)].add(entries[i].cell, space_.grid.cell);
            if (made_for.contains(grounds.root(i))) {
                own_storeys.insert(storeys_.of(entries[i].node));
            }
        }
        std::vector<Entry> found;
        for (const std::size_t i : suspects) {
            const bool is_own = made_for.contains(grounds.root(i));
            const bool is_elsewhere = !is_own && !own_storeys.contains(storeys_.of(entries[i].node));
            // On stairs one leaves it little by little, also above where one can walk.
            const bool is_floor = !is_own || by_floor[floors.root(i)].is_wide();
            if (is_elsewhere || (is_floor && goes_on(entries[i], columns))) {
                found.push_back(entries[i]);
            }
        }
        return found;
    }

    std::set<std::uint32_t> grounds_made_for(const std::vector<Entry>& entries,
                                             collision::DisjointSets& grounds) const {
        std::set<std::uint32_t> made_for;
        std::size_t most = 0;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (is_whole(entries[i].covered)) {
                made_for.insert(grounds.root(i));
            }
            const double more = entries[i].covered - entries[most].covered;
            if (more > kSameCover ||
                (more > -kSameCover && entries[i].y < entries[most].y - kLeastStoreyHeight)) {
                most = i;
            }
        }
        if (made_for.empty()) {
            made_for.insert(grounds.root(most));
        }
        return made_for;
    }

    /// Of the bodies that are really in it, that with the most of it in.
    std::optional<Vec3> deepest_foot(ObjectId trigger, std::vector<Entry>& entries) {
        std::ranges::stable_sort(entries, std::ranges::greater(), &Entry::covered);
        for (std::size_t i = 0; i < entries.size() && i < kMostExactPerStorey; ++i) {
            const Vec3 exact = space_.state_at(entries[i].node, strider_).foot;
            if (is_in(trigger, exact)) {
                return exact;
            }
        }
        return std::nullopt;
    }

    bool is_in(ObjectId trigger, const Vec3& foot) const { return overlaps(trigger, body_.core(foot)); }

    bool is_middle_in(ObjectId trigger, const Vec3& foot) const {
        const Vec3 middle = foot + Vec3(0, 0.5 * body_.height, 0);
        return overlaps(trigger, {middle, middle});
    }

    bool overlaps(ObjectId trigger, const collision::Segment& core) const {
        return collision::overlap_span(world_, trigger, core, body_.radius, Vec3::Zero()).has_value();
    }

    TriggerOverhang overhang(ObjectId trigger, std::size_t storey, const Vec3& foot) const {
        const collision::Aabb& bounds = world_.bounds(trigger);
        TriggerOverhang overhang{trigger, storey, foot};
        overhang.from_above = bounds.center().y() > foot.y() + 0.5 * body_.height;
        overhang.depth =
            overhang.from_above ? foot.y() + body_.height - bounds.min.y() : bounds.max.y() - foot.y();
        for (const ObjectId other : triggers_) {
            if (other != trigger && is_middle_in(other, foot)) {
                overhang.also_in.push_back(other);
            }
        }
        return overhang;
    }

    const collision::World& world_;
    const collision::MoverSettings body_;
    const WalkSpace& space_;
    const Storeys& storeys_;
    Strider strider_;
    std::vector<ObjectId> triggers_;
};

}  // namespace

std::vector<TriggerOverhang> find_trigger_overhangs(const scene::Campus& campus, const WorkerWorlds& worlds,
                                                    const ExploreSettings& settings, const WalkSpace& space,
                                                    const Storeys& storeys) {
    return OverhangFinder(campus, worlds, settings, space, storeys).run();
}

}  // namespace campuswalk::engine
