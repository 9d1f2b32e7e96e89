#include "tools/campuswalk/explore/minimal_walks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>

#include "engine/events/decimals.h"
#include "engine/simulation/body.h"
#include "scene/base/glob.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::explore {

using collision::Vec3;
using engine::fixed;
using engine::WalkReport;

namespace {

/// How far beyond the edge of the world a walk goes, metres.
constexpr double kBeyond = 1.0;

std::string list_of(const Vec3& p) {
    return "[" + fixed(p.x(), 5) + ", " + fixed(p.y(), 5) + ", " + fixed(p.z(), 5) + "]";
}

/// The finding's number, kind and name: letters, digits and dashes.
std::string file_name(std::size_t number, const Finding& finding) {
    const std::string digits = std::to_string(number);
    std::string name = (digits.size() < 2 ? "0" : "") + digits + "-" + name_of(finding.kind) + "-";
    constexpr std::size_t kLongest = 60;
    for (const char c : finding.subject) {
        if (name.size() >= kLongest || c == ',') {
            break;
        }
        const bool plain =
            std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
        if (plain) {
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else if (name.back() != '-') {
            name += '-';
        }
    }
    while (name.back() == '-') {
        name.pop_back();
    }
    return name;
}

/// From `from` towards `to`, where the walk must end once the campus is mended.
std::string steps_yaml(const Vec3& from, const Vec3& to, const std::string& failure, const Finding& finding) {
    return "status: {is: xfail, because: " + json_text(finding.text) + ", failures: [" + failure +
           "]}\nsteps:\n  - spawn: {at: " + list_of(from) + "}\n  - walk_to: " + list_of(to) +
           "\nexpect:\n  - reaches: {place: " + list_of(to) + ", within: 0.5}\n";
}

/// More than a fall from there out of the world takes, also where slopes slow it down: a walk_to that its
/// target is far above ends before.
double fall_seconds(const Vec3& edge, double bottom) {
    constexpr double kSlowed = 2.0;
    constexpr double kToTheEdge = 1.0;
    const double height = edge.y() - bottom + engine::kAbyss;
    return kToTheEdge + kSlowed * std::sqrt(2.0 * height / collision::MoverSettings().gravity);
}

std::optional<std::string> yaml_of(const WalkReport& report, const Finding& finding, double bottom) {
    switch (finding.kind) {
        case FindingKind::unreached:
        case FindingKind::island: {
            if (finding.islands.empty() || !finding.barrier ||
                finding.barrier->kind == engine::BarrierKind::solid) {
                return std::nullopt;
            }
            const engine::Island& island = report.islands[finding.islands.front()].island;
            const Vec3& from = finding.barrier->from;
            return steps_yaml(from, island.nearest_to(from), "blocked", finding);
        }
        case FindingKind::narrow: {
            const auto narrow = std::ranges::find_if(report.narrow, [&](const engine::NarrowPassage& entry) {
                return entry.passage && entry.passage->at == finding.at;
            });
            if (narrow == report.narrow.end() || narrow->passage->kind == engine::BarrierKind::solid) {
                return std::nullopt;
            }
            const Vec3& from = narrow->passage->from;
            return steps_yaml(from, narrow->beyond.nearest_to(from), "blocked", finding);
        }
        case FindingKind::hot:
            return std::nullopt;  // a walk tells no costs
        case FindingKind::trigger:
            return "status: {is: xfail, because: " + json_text(finding.text) +
                   ", failures: [never]}\nsteps:\n  - spawn: {at: " + list_of(finding.at) +
                   "}\n  - wait: 0.1\nexpect:\n  - never: " +
                   json_text("trigger.enter " + scene::glob_for(finding.trigger)) + "\n";
        case FindingKind::trap:
        case FindingKind::stuck: {
            const auto trap = std::ranges::find(report.traps, finding.at, &engine::Trap::edge);
            return steps_yaml(report.space.position(trap->entrance), trap->edge, "blocked", finding);
        }
        case FindingKind::hole: {
            const auto hole = std::ranges::find_if(
                report.holes, [&](const engine::Hole& h) { return h.edges.front().at == finding.at; });
            const Vec3 ahead = engine::grid_directions()[hole->edges.front().stride.direction].unit;
            Vec3 beyond = finding.at + kBeyond * ahead;
            return "status: {is: xfail, because: " + json_text(finding.text) +
                   ", failures: [fell, never]}\nsteps:\n  - spawn: {at: " + list_of(finding.at) +
                   "}\n  - walk_to: {to: " + list_of(beyond) +
                   ", if_blocked: continue}\n  - wait: " + fixed(fall_seconds(finding.at, bottom), 1) +
                   "\nexpect:\n  - never: \"avatar.fell *\"\n";
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<MinimalWalk> minimal_walks(const WalkReport& report, const std::vector<Finding>& findings,
                                       const WalkHeader& header) {
    std::vector<MinimalWalk> walks;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& finding = findings[i];
        if (const auto steps = yaml_of(report, finding, header.bottom)) {
            walks.push_back({file_name(i + 1, finding),
                             "# Finding " + std::to_string(i + 1) +
                                 " of `campuswalk explore`. Once it is mended, " +
                                 "take away `status`.\ncampus: " + json_text(header.campus) + "\navatar: " +
                                 (finding.kind == FindingKind::narrow ? header.wide_avatar : header.avatar) +
                                 "\n" + *steps});
        }
    }
    return walks;
}

}  // namespace campuswalk::tools::explore
