#include "tools/campuswalk/explore/findings.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/events/decimals.h"
#include "engine/walkspace/barrier/barrier_reason.h"
#include "tools/campuswalk/explore/bottleneck_text.h"
#include "tools/campuswalk/explore/building_popups.h"
#include "tools/campuswalk/explore/island_groups.h"

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
    return island.barrier ? text_of(reason_of(campus, *island.barrier))
                          : "nothing that is reached lies near it";
}

/// Where the others of several like things are: the first few.
std::string likewise_at(const std::vector<collision::Vec3>& places) {
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t i = 1; i < places.size() && i <= kMost; ++i) {
        text += (i == 1 ? "; likewise at " : "; ") + engine::coordinates_text(places[i]);
    }
    return places.size() <= kMost + 1
               ? text
               : text + " and at " + std::to_string(places.size() - kMost - 1) + " more";
}

std::string named(const engine::Subject& subject) {
    return std::string(engine::name_of(subject.kind)) + " " + subject.name;
}

/// The middle of the building's first object, if it has any.
std::optional<collision::Vec3> place_of(const scene::Campus& campus, std::size_t building) {
    const auto first = std::ranges::find(campus.objects, building, &scene::CampusObject::building);
    if (first == campus.objects.end()) {
        return std::nullopt;
    }
    return campus.world.bounds(static_cast<collision::ObjectId>(first - campus.objects.begin())).center();
}

const BuildingPopup* find_popup(const std::vector<BuildingPopup>& popups, std::size_t building) {
    const auto popup = std::ranges::find(popups, building, &BuildingPopup::building);
    return popup == popups.end() ? nullptr : &*popup;
}

void add_untouched_building(const scene::Campus& campus, const engine::Subject& subject,
                            const std::vector<BuildingPopup>& popups, std::vector<Finding>& findings) {
    const std::vector<scene::Building>& buildings = campus.description.buildings;
    const auto building = static_cast<std::size_t>(
        std::ranges::find(buildings, subject.name, &scene::Building::id) - buildings.begin());
    Finding finding{FindingKind::unreached, named(subject), "nobody touches, enters or sees anything of it",
                    place_of(campus, building)};
    if (find_popup(popups, building) != nullptr) {
        finding.text += ", so that its pop-up never opens";
        finding.also.push_back(FindingKind::popup);
    }
    findings.push_back(std::move(finding));
}

/// One that nobody can enter is a fault of a trigger, too.
void note_trigger(const engine::Subject& subject, Finding& finding) {
    if (subject.kind == SubjectKind::trigger &&
        std::ranges::find(finding.also, FindingKind::trigger) == finding.also.end()) {
        finding.also.push_back(FindingKind::trigger);
    }
}

/// Adds a finding for each unreached subject; those on one island share it.
void add_unreached(const scene::Campus& campus, const WalkReport& report,
                   const std::vector<BuildingPopup>& popups, std::vector<Finding>& findings) {
    std::map<std::size_t, std::size_t> by_island;
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        if (subject.reached || !engine::is_destination(subject.kind)) {
            continue;
        }
        if (subject.kind == SubjectKind::building) {
            add_untouched_building(campus, subject, popups, findings);
            continue;
        }
        if (!subject.island) {
            findings.push_back({FindingKind::unreached, named(subject), why_unreached(subject), subject.at});
            note_trigger(subject, findings.back());
            continue;
        }
        const auto [known, added] = by_island.emplace(*subject.island, findings.size());
        if (!added) {
            findings[known->second].subject += ", " + named(subject);
            note_trigger(subject, findings[known->second]);
            continue;
        }
        const engine::IslandReport& island = report.islands[*subject.island];
        Finding finding{FindingKind::unreached, named(subject),   why(campus, island), subject.at,
                        island.barrier,         {*subject.island}};
        if (const double area = island.island.area(report.space.grid); area > engine::kNotableIsland) {
            finding.text += "; " + area_text(area) + " of ground lie beyond";
        }
        if (island.barrier) {
            finding.at = island.barrier->at;
        }
        note_trigger(subject, finding);
        findings.push_back(std::move(finding));
    }
}

/// How one gets into a trap.
std::string entry_text(double drop) {
    constexpr double kLevel = 0.05;  // metres: no edge
    return drop < kLevel ? "one gets in" : "one gets in over an edge of " + fixed(drop, 2) + " m";
}

void add_traps(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    const double cell = report.space.grid.cell * report.space.grid.cell;
    for (const engine::Trap& trap : report.traps) {
        const double area = static_cast<double>(trap.nodes.size()) * cell;
        const bool small = area < kStuckArea;
        findings.push_back({small ? FindingKind::stuck : FindingKind::trap,
                            (small ? "stuck spot of " : "trap of ") + area_text(area),
                            entry_text(trap.drop) + " and not out again" +
                                (trap.out ? ": " + text_of(reason_of(campus, *trap.out)) : ""),
                            trap.edge});
        findings.back().index = static_cast<std::size_t>(&trap - report.traps.data());
    }
}

void add_holes(const WalkReport& report, std::vector<Finding>& findings) {
    for (const engine::Hole& hole : report.holes) {
        findings.push_back({FindingKind::hole, "hole",
                            "one falls out of the world along " + fixed(hole.length, 1) + " m of an edge",
                            hole.edges.front().at});
        findings.back().index = static_cast<std::size_t>(&hole - report.holes.data());
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
                            entry.passage ? text_of(reason_of(campus, *entry.passage))
                                          : "nothing that a wide visitor reaches lies near it",
                            entry.passage ? entry.passage->at : foot, entry.passage});
        findings.back().index = static_cast<std::size_t>(&entry - report.narrow.data());
    }
}

/// Those that lie behind another narrow passage, and so on; doors of one kind share a finding.
void add_bottlenecks(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    std::vector<std::pair<std::string, std::vector<collision::Vec3>>> like;  // the narrowest first
    for (const engine::Bottleneck& bottleneck : report.bottlenecks) {
        if (is_finding(report, bottleneck)) {
            const std::string text = bottleneck_text(campus, bottleneck);
            auto known = std::ranges::find(like, text, [](const auto& each) { return each.first; });
            if (known == like.end()) {
                known = like.insert(known, {text, {}});
            }
            known->second.push_back(bottleneck.passage.foot);
        }
    }
    for (const auto& [text, places] : like) {
        const std::string count = std::to_string(places.size());
        findings.push_back({FindingKind::narrow,
                            places.size() == 1 ? "narrow passage" : count + " narrow passages",
                            text + likewise_at(places), places.front()});
        findings.back().count = places.size();
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

/// Pop-ups of buildings that one does come into contact with, by objects that don't open them.
void add_popups(const scene::Campus& campus, const WalkReport& report,
                const std::vector<BuildingPopup>& popups, std::vector<Finding>& findings) {
    constexpr std::size_t kMost = 3;
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        const auto popup = std::ranges::find_if(popups, [&](const BuildingPopup& each) {
            return campus.description.buildings[each.building].id == subject.name;
        });
        if (subject.kind != SubjectKind::building || !subject.reached || popup == popups.end() ||
            popup->opens) {
            continue;
        }
        const std::vector<collision::ObjectId>& openers = popup->openers;
        std::string names;
        for (std::size_t i = 0; i < openers.size() && i < kMost; ++i) {
            names += (i == 0 ? "" : ", ") + campus.objects[index_of(openers[i])].id;
        }
        names += openers.size() > kMost ? " and " + std::to_string(openers.size() - kMost) + " more" : "";
        findings.push_back({FindingKind::popup, named(subject),
                            "its pop-up never opens: nobody comes into contact with what opens it, " + names,
                            campus.world.bounds(openers.front()).center()});
    }
}

/// "4.0 m²", or of several "3.5 to 4.0 m² each".
std::string areas_text(const WalkReport& report, const IslandGroup& group) {
    const auto area = [&](std::size_t i) { return report.islands[i].island.area(report.space.grid); };
    const std::string largest = area_text(area(group.islands.front()));
    const std::string smallest = area_text(area(group.islands.back()));
    const std::size_t unit = smallest.find(' ');
    return (smallest == largest ? largest : smallest.substr(0, unit) + " to " + largest) +
           (group.islands.size() > 1 ? " each" : "");
}

/// How much higher than the foot of their riser they lie, where that takes more than this one riser.
std::string rise_text(const WalkReport& report, const IslandGroup& group) {
    constexpr double kMore = 0.05;
    double low = 1e300;
    double high = 0.0;
    for (const std::size_t i : group.islands) {
        const engine::Barrier& barrier = *report.islands[i].barrier;
        const double up = report.islands[i].island.nearest_to(barrier.from).y() - barrier.from.y();
        if (barrier.kind != engine::ReasonKind::riser || up < barrier.measured + kMore) {
            return "";
        }
        low = std::min(low, up);
        high = std::max(high, up);
    }
    const std::string highest = fixed(high, 2) + " m up";
    return fixed(low, 2) == fixed(high, 2) ? ", " + highest : ", " + fixed(low, 2) + " to " + highest;
}

/// Those that no subject's finding tells of already.
void add_islands(const scene::Campus& campus, const WalkReport& report, std::vector<Finding>& findings) {
    std::set<std::size_t> told;
    for (const Finding& finding : findings) {
        told.insert(finding.islands.begin(), finding.islands.end());
    }
    for (const IslandGroup& group : group_islands(campus, report, told)) {
        const engine::IslandReport& largest = report.islands[group.islands.front()];
        const std::size_t count = group.islands.size();
        std::vector<collision::Vec3> places;
        for (const std::size_t i : group.islands) {
            places.push_back(report.islands[i].island.spots.front().at.foot);
        }
        const std::string islands = count == 1 ? "island" : std::to_string(count) + " islands";
        findings.push_back(
            {FindingKind::island,
             islands + " of " + areas_text(report, group) + " on " + group.on + rise_text(report, group),
             why(campus, largest) + likewise_at(places), largest.island.spots.front().at.foot,
             largest.barrier, group.islands});
        findings.back().count = count;
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

/// Why nothing that is reached is near enough to the subject.
std::string why_no_nearer(const engine::Subject& subject) {
    const engine::Reason& reason = *subject.reason;
    if (reason.measured) {
        return "one gets to " + fixed(*reason.measured, 3) + " m from it, not nearer" +
               (reason.object.empty() ? "" : ": " + reason.object + " is there");
    }
    if (reason.allowed) {
        return "no place within " + fixed(*reason.allowed, 1) + " m of it is reached";
    }
    return subject.kind == SubjectKind::solid ? "nobody gets near it"
                                              : "nothing that is reached lies near it";
}

}  // namespace

std::vector<Finding> find_findings(const scene::Campus& campus, const WalkReport& report) {
    std::vector<Finding> findings;
    const std::vector<BuildingPopup> popups = building_popups(campus, report);
    add_unreached(campus, report, popups, findings);
    add_traps(campus, report, findings);
    add_holes(report, findings);
    add_narrow_passages(campus, report, findings);
    add_bottlenecks(campus, report, findings);
    add_overhangs(campus, report, findings);
    add_popups(campus, report, popups, findings);
    add_islands(campus, report, findings);
    add_hot_spots(campus, report, findings);
    return findings;
}

std::string why_unreached(const engine::Subject& subject) {
    switch (subject.reason->kind) {
        case engine::ReasonKind::unsearched:
            return "it isn't on the ground that was explored, and there is more";
        case engine::ReasonKind::no_room:
            return "there is no place in it where the body could stand";
        case engine::ReasonKind::contact:
            return "other objects hide it";
        case engine::ReasonKind::no_nearer:
            return why_no_nearer(subject);
        default:
            return text_of(*subject.reason);
    }
}

const char* name_of(FindingKind kind) {
    return std::ranges::find(kFindingNames, kind, &FindingName::kind)->name;
}

bool is_of_kind(const Finding& finding, const std::string& name) {
    return name_of(finding.kind) == name ||
           std::ranges::any_of(finding.also, [&](FindingKind kind) { return name_of(kind) == name; });
}

}  // namespace campuswalk::tools::explore
