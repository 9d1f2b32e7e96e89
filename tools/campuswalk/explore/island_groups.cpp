#include "tools/campuswalk/explore/island_groups.h"

#include <cctype>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "engine/walkspace/barrier/barrier_reason.h"

namespace campuswalk::tools::explore {

namespace {

/// Barriers whose numbers differ by less look the same: metres, or radians.
constexpr double kSameNumber = 0.01;

/// The name with each number in it as a star.
std::string family_of(const std::string& name) {
    std::string family;
    for (const char c : name) {
        if (std::isdigit(static_cast<unsigned char>(c)) == 0) {
            family += c;
        } else if (family.empty() || family.back() != '*') {
            family += '*';
        }
    }
    return family;
}

/// A barrier's kind, its number, and what it is, if that matters.
using BarrierKey = std::tuple<engine::ReasonKind, long, std::string>;
/// What islands of one group have in common.
using GroupKey = std::pair<std::string, std::vector<BarrierKey>>;

BarrierKey key_of(const scene::Campus& campus, const engine::Barrier& barrier) {
    const bool is_about_object = barrier.object && barrier.kind != engine::ReasonKind::riser &&
                                 barrier.kind != engine::ReasonKind::slope &&
                                 barrier.kind != engine::ReasonKind::several;
    return {barrier.kind, std::lround(barrier.measured / kSameNumber),
            is_about_object ? family_of(engine::object_text(campus, *barrier.object, barrier.at)) : ""};
}

GroupKey key_of(const scene::Campus& campus, const engine::Barrier& barrier, const std::string& on) {
    GroupKey key{family_of(on), {}};
    if (barrier.kind != engine::ReasonKind::sequence) {
        key.second.push_back(key_of(campus, barrier));
        return key;
    }
    for (const engine::Barrier& part : barrier.parts) {
        key.second.push_back(key_of(campus, part));
    }
    return key;
}

/// A finding even if nothing that somebody wants to get to is on it.
bool is_notable(const engine::WalkReport& report, const engine::IslandReport& island) {
    return island.island.area(report.space.grid) > engine::kNotableIsland && !is_top(island) &&
           !island.hollow;
}

}  // namespace

bool is_top(const engine::IslandReport& island) {
    if (!island.barrier) {
        return true;
    }
    const engine::Barrier& barrier = *island.barrier;
    const bool is_sequence = barrier.kind == engine::ReasonKind::sequence;
    return (is_sequence ? barrier.parts.back() : barrier).kind == engine::ReasonKind::ledge;
}

std::vector<IslandGroup> group_islands(const scene::Campus& campus, const engine::WalkReport& report,
                                       const std::set<std::size_t>& told) {
    std::vector<IslandGroup> groups;
    std::map<GroupKey, std::size_t> known;
    for (std::size_t i = 0; i < report.islands.size(); ++i) {
        const engine::IslandReport& entry = report.islands[i];
        if (!is_notable(report, entry) || told.contains(i)) {
            continue;
        }
        const engine::UnreachedSpot& spot = entry.island.spots.front();
        const std::string on = engine::object_text(campus, spot.object, spot.at.foot);
        const auto [group, added] = known.emplace(key_of(campus, *entry.barrier, on), groups.size());
        if (added) {
            groups.push_back({{i}, on});
            continue;
        }
        IslandGroup& joined = groups[group->second];
        joined.islands.push_back(i);
        joined.on = joined.on == on ? on : family_of(on);
    }
    return groups;
}

}  // namespace campuswalk::tools::explore
