#include "engine/walkspace/trigger_overhangs.h"

#include <map>
#include <utility>

#include "collision/world/overlap_span.h"

namespace campuswalk::engine {

using collision::Detection;
using collision::ObjectId;
using collision::Vec3;

namespace {

/// Nodes of one storey whose exact state is computed to test one trigger.
constexpr std::size_t kMostExactPerStorey = 64;

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
            const std::map<std::size_t, Entry> entries = entries_to(trigger);
            bool is_made_for_one = false;
            for (const auto& [storey, entry] : entries) {
                is_made_for_one = is_made_for_one || entry.is_made_for;
            }
            for (const auto& [storey, entry] : entries) {
                if (is_made_for_one && !entry.is_made_for && entry.foot) {
                    found.push_back(overhang(trigger, storey, *entry.foot));
                }
            }
        }
        return found;
    }

private:
    /// How a trigger is entered from one storey.
    struct Entry {
        bool is_made_for = false;
        std::size_t tried = 0;
        std::optional<Vec3> foot;  ///< of a body that is in it
    };

    std::map<std::size_t, Entry> entries_to(ObjectId trigger) {
        std::map<std::size_t, Entry> entries;
        const collision::Aabb& bounds = world_.bounds(trigger);
        for (const WalkNodeId& node : space_.nodes_touching(bounds, body_)) {
            Entry& entry = entries[storeys_.of(node)];
            if (entry.is_made_for || space_.node(node).low != 0) {
                continue;
            }
            const Vec3 foot = space_.position(node);
            if (is_middle_in(trigger, foot) || is_at_middle_of(bounds, foot)) {
                entry.is_made_for = true;
            } else if (!entry.foot && entry.tried < kMostExactPerStorey && is_in(trigger, foot)) {
                ++entry.tried;
                const Vec3 exact = space_.state_at(node, strider_).foot;
                if (is_in(trigger, exact)) {
                    entry.foot = exact;
                }
            }
        }
        return entries;
    }

    bool is_in(ObjectId trigger, const Vec3& foot) const { return overlaps(trigger, body_.core(foot)); }

    bool is_middle_in(ObjectId trigger, const Vec3& foot) const {
        const Vec3 middle = foot + Vec3(0, 0.5 * body_.height, 0);
        return overlaps(trigger, {middle, middle});
    }

    bool overlaps(ObjectId trigger, const collision::Segment& core) const {
        return collision::overlap_span(world_, trigger, core, body_.radius, Vec3::Zero()).has_value();
    }

    bool is_at_middle_of(const collision::Aabb& bounds, const Vec3& foot) const {
        const double middle = bounds.center().y();
        return middle >= foot.y() && middle <= foot.y() + body_.height;
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
