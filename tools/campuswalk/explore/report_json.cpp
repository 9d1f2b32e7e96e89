#include "tools/campuswalk/explore/report_json.h"

#include <cmath>
#include <map>

#include "engine/events/decimals.h"
#include "engine/walkspace/barrier/barrier_reason.h"
#include "scene/campus/node_at.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/explore/building_popups.h"
#include "tools/campuswalk/explore/island_groups.h"
#include "tools/campuswalk/explore/start_names.h"

namespace campuswalk::tools::explore {

using engine::WalkReport;

namespace {

/// To a hundredth of a millimetre: what a walk file needs to put the avatar down there.
double rounded(double value) {
    return std::floor(value * 1e5 + 0.5) / 1e5;
}

Json json_of(const collision::Vec3& p) {
    return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

Json json_of(const scene::Campus& campus, const engine::Barrier& barrier) {
    const bool is_slope = barrier.kind == engine::ReasonKind::slope;
    const auto number = [&](double value) { return rounded(is_slope ? engine::degrees(value) : value); };
    Json json = {{"kind", engine::name_of(barrier.kind)}};
    if (has_measure(barrier.kind)) {
        json[is_slope ? "measured_deg" : "measured"] = number(barrier.measured);
        json[is_slope ? "allowed_deg" : "allowed"] = number(barrier.allowed);
    }
    json["at"] = json_of(barrier.at);
    json["from"] = json_of(barrier.from);
    if (barrier.object) {
        const scene::CampusObject& object = campus.objects[index_of(*barrier.object)];
        json["object"] = object.id;
        json["node"] = scene::node_at(campus, object, barrier.at);
    }
    json["parts"] = Json::array();
    for (const engine::Barrier& part : barrier.parts) {
        json["parts"].push_back(json_of(campus, part));
    }
    return json;
}

Json storeys_json(const WalkReport& report) {
    Json json = Json::array();
    for (const engine::Storey& storey : report.storeys.list) {
        json.push_back({{"area", rounded(storey.area)},
                        {"main_height", rounded(storey.main_height)},
                        {"low", rounded(storey.low)},
                        {"high", rounded(storey.high)}});
    }
    return json;
}

Json subjects_json(const scene::Campus& campus, const WalkReport& report) {
    std::map<std::string, bool> opens;
    for (const BuildingPopup& popup : building_popups(campus, report)) {
        opens.emplace(campus.description.buildings[popup.building].id, popup.opens);
    }
    Json json = Json::array();
    for (const engine::SubjectReport& entry : report.subjects) {
        const engine::Subject& subject = entry.subject;
        Json one = {
            {"kind", engine::name_of(subject.kind)}, {"name", subject.name}, {"reached", subject.reached}};
        if (subject.kind != engine::SubjectKind::building || subject.reached) {
            one["at"] = json_of(subject.at);
        }
        if (subject.kind == engine::SubjectKind::building && opens.contains(subject.name)) {
            one["popup_opens"] = opens.at(subject.name);
        }
        if (subject.kind == engine::SubjectKind::door) {
            one["walked_through"] = subject.walked_through;
        }
        if (entry.distance) {
            one["distance"] = rounded(*entry.distance);
            one["from"] = start_of(campus, report, entry);
        }
        if (subject.island) {
            one["island"] = *subject.island;
        }
        if (subject.reason) {
            one["reason"] = why_unreached(subject);
        }
        json.push_back(std::move(one));
    }
    return json;
}

/// Those that are worth a line, or that a subject is on.
Json islands_json(const scene::Campus& campus, const WalkReport& report,
                  const std::vector<Finding>& findings) {
    std::map<const engine::IslandReport*, std::size_t> finding_of;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        for (const std::size_t island : findings[i].islands) {
            finding_of.emplace(&report.islands[island], i + 1);
        }
    }
    Json json = Json::array();
    for (const engine::IslandReport& entry : report.islands) {
        const double area = entry.island.area(report.space.grid);
        const bool named = std::ranges::any_of(report.subjects, [&](const engine::SubjectReport& s) {
            return s.subject.island && &report.islands[*s.subject.island] == &entry;
        });
        if (area <= engine::kNotableIsland && !named) {
            break;  // the largest come first; what is smaller has no subject on it, or is counted before
        }
        const engine::UnreachedSpot& spot = entry.island.spots.front();
        Json one = {{"area", rounded(area)},
                    {"at", json_of(spot.at.foot)},
                    {"object", campus.objects[index_of(spot.object)].id},
                    {"bounds",
                     {{"min", json_of(entry.island.bounds.min)}, {"max", json_of(entry.island.bounds.max)}}},
                    {"top", !entry.hollow && is_top(entry)},
                    {"hollow", entry.hollow}};
        const auto finding = finding_of.find(&entry);
        one["finding"] = finding == finding_of.end() ? Json() : Json(finding->second);
        one["barrier"] = entry.barrier ? json_of(campus, *entry.barrier) : Json();
        json.push_back(std::move(one));
    }
    return json;
}

Json traps_json(const scene::Campus& campus, const WalkReport& report) {
    Json json = Json::array();
    for (const engine::Trap& trap : report.traps) {
        const double cell = report.space.grid.cell;
        Json one = {{"area", rounded(static_cast<double>(trap.nodes.size()) * cell * cell)},
                    {"edge", json_of(trap.edge)},
                    {"at", json_of(report.space.position(trap.entrance))},
                    {"drop", rounded(trap.drop)}};
        one["out"] = trap.out ? json_of(campus, *trap.out) : Json();
        json.push_back(std::move(one));
    }
    return json;
}

Json holes_json(const WalkReport& report) {
    Json json = Json::array();
    for (const engine::Hole& hole : report.holes) {
        json.push_back({{"length", rounded(hole.length)}, {"edge", json_of(hole.edges.front().at)}});
    }
    return json;
}

Json narrow_json(const scene::Campus& campus, const WalkReport& report) {
    Json json = Json::array();
    for (const engine::NarrowPassage& entry : report.narrow) {
        Json one = {{"area", rounded(entry.beyond.area(report.space.grid))},
                    {"at", json_of(entry.beyond.spots.front().at.foot)}};
        one["barrier"] = entry.passage ? json_of(campus, *entry.passage) : Json();
        json.push_back(std::move(one));
    }
    return json;
}

Json bottlenecks_json(const scene::Campus& campus, const WalkReport& report) {
    Json json = Json::array();
    for (const engine::Bottleneck& bottleneck : report.bottlenecks) {
        Json between = Json::array();
        for (const engine::PassageSide& side : bottleneck.passage.sides) {
            const scene::CampusObject& object = campus.objects[index_of(side.object)];
            between.push_back({{"object", object.id},
                               {"node", scene::node_at(campus, object, side.at)},
                               {"at", json_of(side.at)}});
        }
        json.push_back({{"at", json_of(bottleneck.passage.foot)},
                        {"width", rounded(bottleneck.passage.width)},
                        {"between", std::move(between)},
                        {"only_path", bottleneck.is_only_path}});
    }
    return json;
}

Json overhangs_json(const scene::Campus& campus, const WalkReport& report) {
    Json json = Json::array();
    for (const engine::TriggerOverhang& overhang : report.overhangs) {
        Json also_in = Json::array();
        for (const collision::ObjectId other : overhang.also_in) {
            also_in.push_back(campus.objects[index_of(other)].id);
        }
        json.push_back({{"trigger", campus.objects[index_of(overhang.trigger)].id},
                        {"storey", overhang.storey},
                        {"at", json_of(overhang.foot)},
                        {"part", overhang.from_above ? "head" : "feet"},
                        {"depth", rounded(overhang.depth)},
                        {"also_in", std::move(also_in)}});
    }
    return json;
}

Json hot_spots_json(const scene::Campus& campus, const WalkReport& report) {
    Json json = Json::array();
    for (const engine::HotSpot& spot : report.hot_spots) {
        json.push_back({{"at", json_of(spot.foot)},
                        {"pieces", spot.pieces},
                        {"object", campus.objects[index_of(spot.object)].id}});
    }
    return json;
}

Json coverage_json(const WalkReport& report, const Coverage& coverage) {
    Json json = {{"walks", coverage.walks},        {"failed", coverage.failed},
                 {"area", rounded(coverage.area)}, {"share", rounded(coverage.share)},
                 {"visited", Json::array()},       {"missed", Json::array()}};
    for (std::size_t i = 0; i < report.subjects.size(); ++i) {
        const engine::Subject& subject = report.subjects[i].subject;
        const bool counts =
            subject.kind == engine::SubjectKind::building || subject.kind == engine::SubjectKind::trigger;
        if (counts && (subject.reached || coverage.visited[i])) {
            json[coverage.visited[i] ? "visited" : "missed"].push_back(
                {{"kind", engine::name_of(subject.kind)}, {"name", subject.name}});
        }
    }
    return json;
}

Json separate_json(const scene::Campus& campus, const WalkReport& report) {
    Json json = Json::array();
    for (const engine::SeparateGround& ground : report.separate) {
        Json spawns = Json::array();
        for (const std::uint32_t start : ground.starts) {
            spawns.push_back(name_of_start(campus, report, report.space.starts[start]));
        }
        json.push_back({{"spawns", std::move(spawns)}, {"area", rounded(ground.area)}});
    }
    return json;
}

Json finding_json(const Finding& finding, std::size_t number) {
    Json json = {{"number", number},
                 {"kind", name_of(finding.kind)},
                 {"subject", finding.subject},
                 {"text", finding.text}};
    for (const FindingKind kind : finding.also) {
        json["also"].push_back(name_of(kind));
    }
    if (finding.at) {
        json["at"] = json_of(*finding.at);
    }
    return json;
}

Json bounds_json(const WalkReport& report) {
    Json json = Json::array();
    for (const engine::Bound bound : report.space.bounds) {
        json.push_back(engine::kBoundNames.at(static_cast<std::size_t>(bound)));
    }
    return json;
}

}  // namespace

std::string report_json(const scene::Campus& campus, const WalkReport& report,
                        const std::vector<Finding>& findings, const Coverage* coverage) {
    Json json = {{"campuswalk_explore", 1},
                 {"campus", campus.description.name},
                 {"cell", report.space.grid.cell},
                 {"area", rounded(report.space.area())},
                 {"crouched_area", rounded(report.space.low_area())},
                 {"incomplete", bounds_json(report)},
                 {"storeys", storeys_json(report)},
                 {"subjects", subjects_json(campus, report)},
                 {"islands", islands_json(campus, report, findings)},
                 {"traps", traps_json(campus, report)},
                 {"holes", holes_json(report)},
                 {"narrow", narrow_json(campus, report)},
                 {"bottlenecks", bottlenecks_json(campus, report)},
                 {"overhangs", overhangs_json(campus, report)},
                 {"hot_spots", hot_spots_json(campus, report)},
                 {"separate", separate_json(campus, report)},
                 {"findings", Json::array()}};
    for (std::size_t i = 0; i < findings.size(); ++i) {
        json["findings"].push_back(finding_json(findings[i], i + 1));
    }
    if (coverage != nullptr) {
        json["coverage"] = coverage_json(report, *coverage);
    }
    return json_text(json, 2) + "\n";
}

}  // namespace campuswalk::tools::explore
