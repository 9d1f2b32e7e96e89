#include "tools/campuswalk/explore/findings.h"

#include <map>
#include <set>

#include "engine/events/decimals.h"
#include "engine/walkspace/barrier_text.h"

namespace campuswalk::tools::explore {

using engine::fixed;
using engine::SubjectKind;
using engine::WalkReport;

namespace {

/// A trap smaller than this is a spot where one is stuck, m².
constexpr double kStuckArea = 1.0;

/// A square metre, as people say it.
std::string area_text(double area) {
    return fixed(area, area < 10.0 ? 1 : 0) + " m²";
}

std::string why(const scene::Campus& campus, const engine::IslandReport& island) {
    return island.barrier ? engine::barrier_text(campus, *island.barrier)
                          : "nothing that is reached lies near it";
}

std::string named(const engine::Subject& subject) {
    return std::string(engine::name_of(subject.kind)) + " " + subject.name;
}

/// Solids are findings only by themselves; where nobody gets, nobody touches them.
bool is_wanted(const engine::Subject& subject) {
    return subject.kind != SubjectKind::solid;
}

/// Adds a finding for each unreached subject; those on one island share it.
void add_unreached(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    std::map<std::size_t, std::size_t> by_island;
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        if (subject.reached || !is_wanted(subject)) {
            continue;
        }
        if (subject.kind == SubjectKind::building && subject.reason.empty() && !subject.island) {
            findings.push_back(
                {FindingKind::unreached, named(subject), "no contact with it is possible", subject.at});
            continue;
        }
        if (!subject.island) {
            findings.push_back({FindingKind::unreached, named(subject), subject.reason, subject.at});
            continue;
        }
        const auto [known, added] = by_island.emplace(*subject.island, findings.size());
        if (!added) {
            findings[known->second].subject += ", " + named(subject);
            continue;
        }
        const engine::IslandReport& island = report.islands[*subject.island];
        Finding finding{FindingKind::unreached, named(subject), why(campus, island), subject.at,
                        island.barrier,         subject.island};
        if (island.barrier) {
            finding.at = island.barrier->at;
        }
        findings.push_back(std::move(finding));
    }
}

void add_traps(const WalkReport& report, std::vector<Finding>& findings) {
    const double cell = report.space.grid.cell * report.space.grid.cell;
    for (const engine::Trap& trap : report.traps) {
        const double area = static_cast<double>(trap.nodes.size()) * cell;
        const bool small = area < kStuckArea;
        findings.push_back({small ? FindingKind::stuck : FindingKind::trap,
                            (small ? "stuck spot of " : "trap of ") + area_text(area),
                            "one gets in over an edge of " + fixed(trap.drop, 2) + " m and not out again",
                            trap.edge});
    }
}

void add_holes(const WalkReport& report, std::vector<Finding>& findings) {
    for (const engine::Hole& hole : report.holes) {
        findings.push_back({FindingKind::hole, "hole",
                            "one falls out of the world along " + fixed(hole.length, 1) + " m of an edge",
                            hole.edges.front().at});
    }
}

/// Places on ground that a wide body doesn't get to.
std::string places_on(const WalkReport& report, const engine::Island& ground) {
    std::set<engine::GridCell> cells;
    for (const engine::UnreachedSpot& spot : ground.spots) {
        cells.insert(report.space.grid.cell_at(spot.at.foot));
    }
    std::string names;
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        if (subject.kind == SubjectKind::place && subject.reached &&
            ground.bounds.grown(1.0).overlaps({subject.at, subject.at}) &&
            cells.contains(report.space.grid.cell_at(subject.at))) {
            names += (names.empty() ? "" : ", ") + subject.name;
        }
    }
    return names;
}

void add_narrow_passages(const scene::Campus& campus, const WalkReport& report,
                         std::vector<Finding>& findings) {
    for (const engine::NarrowPassage& entry : report.narrow) {
        const std::string places = places_on(report, entry.beyond);
        const collision::Vec3& foot = entry.beyond.spots.front().at.foot;
        findings.push_back({FindingKind::narrow,
                            "narrow passage to " + area_text(entry.beyond.area(report.space.grid)) +
                                (places.empty() ? "" : ", place " + places),
                            entry.passage ? engine::barrier_text(campus, *entry.passage)
                                          : "nothing that a wide visitor reaches lies near it",
                            entry.passage ? entry.passage->at : foot, entry.passage});
    }
}

void add_overhangs(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    for (const engine::TriggerOverhang& overhang : report.overhangs) {
        std::string text = "it reaches through the floor: on storey " + std::to_string(overhang.storey) +
                           " one is in it with the " + (overhang.from_above ? "head" : "feet") + " only, " +
                           fixed(overhang.depth, 2) + " m deep";
        for (std::size_t i = 0; i < overhang.also_in.size(); ++i) {
            text += (i == 0 ? ", and at once in " : ", ") + campus.objects[index_of(overhang.also_in[i])].id;
        }
        const std::string& trigger = campus.objects[index_of(overhang.trigger)].id;
        Finding finding{FindingKind::trigger, "trigger " + trigger, std::move(text), overhang.foot};
        finding.trigger = trigger;
        findings.push_back(std::move(finding));
    }
}

/// Those that no subject's finding tells of already.
void add_islands(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    std::set<std::size_t> told;
    for (const Finding& finding : findings) {
        if (finding.island) {
            told.insert(*finding.island);
        }
    }
    for (std::size_t i = 0; i < report.islands.size(); ++i) {
        const engine::IslandReport& entry = report.islands[i];
        const double area = entry.island.area(report.space.grid);
        if (area <= engine::kNotableIsland || is_top(entry) || told.contains(i)) {
            continue;
        }
        const engine::UnreachedSpot& spot = entry.island.spots.front();
        const std::string on = engine::object_text(campus, spot.object, spot.at.foot);
        findings.push_back({FindingKind::island, "island of " + area_text(area) + " on " + on,
                            why(campus, entry), spot.at.foot, entry.barrier, i});
    }
}

void add_hot_spots(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    for (const engine::HotSpot& spot : report.hot_spots) {
        findings.push_back({FindingKind::hot, "hot spot",
                            std::to_string(spot.pieces) +
                                " triangles and solids are within a step of the visitor, most of " +
                                engine::object_text(campus, spot.object, spot.foot) +
                                ": every tick there takes long",
                            spot.foot});
    }
}

}  // namespace

bool is_top(const engine::IslandReport& island) {
    return !island.barrier || island.barrier->kind == engine::BarrierKind::ledge;
}

std::vector<Finding> find_findings(const scene::Campus& campus, const WalkReport& report) {
    std::vector<Finding> findings;
    add_unreached(campus, report, findings);
    add_traps(report, findings);
    add_holes(report, findings);
    add_narrow_passages(campus, report, findings);
    add_overhangs(campus, report, findings);
    add_islands(campus, report, findings);
    add_hot_spots(campus, report, findings);
    return findings;
}

const char* name_of(FindingKind kind) {
    switch (kind) {
        case FindingKind::unreached:
            return "unreached";
        case FindingKind::trap:
            return "traps";
        case FindingKind::stuck:
            return "stuck";
        case FindingKind::hole:
            return "holes";
        case FindingKind::narrow:
            return "narrow";
        case FindingKind::trigger:
            return "triggers";
        case FindingKind::island:
            return "islands";
        case FindingKind::hot:
            return "hot";
    }
    return "";
}

}  // namespace campuswalk::tools::explore
