#include "tools/campuswalk/explore/report_text.h"

#include <algorithm>
#include <array>

#include "engine/events/decimals.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/explore/bottleneck_text.h"
#include "tools/campuswalk/explore/building_popups.h"
#include "tools/campuswalk/explore/island_groups.h"
#include "tools/campuswalk/explore/start_names.h"

namespace campuswalk::tools::explore {

using engine::fixed;
using engine::SubjectKind;
using engine::WalkReport;

namespace {

const char* text_of(engine::Bound bound) {
    switch (bound) {
        case engine::Bound::nodes:
            return "the most cells that are explored were reached: see --max-cells";
        case engine::Bound::levels:
            return "there were more levels above one another than are kept";
        case engine::Bound::falls:
            return "a fall didn't end: a body hung somewhere, or fell for half a minute";
        case engine::Bound::steering:
            return "in falls of over half a metre, some ways to steer were tried, not all";
        case engine::Bound::islands:
            return "there is more ground that isn't reached than is looked at, so none of it is listed";
    }
    return "";
}

void print_reached(const WalkReport& report) {
    const std::vector<engine::Storey>& storeys = report.storeys.list;
    const std::string area = fixed(report.space.area(), 1) + " m²";
    if (storeys.size() == 1) {
        print_line("reached    %s from %s to %s m", area.c_str(), fixed(storeys[0].low, 2).c_str(),
                   fixed(storeys[0].high, 2).c_str());
    } else {
        print_line("reached    %s", area.c_str());
    }
    for (std::size_t i = 0; i < storeys.size() && storeys.size() > 1; ++i) {
        const engine::Storey& storey = storeys[i];
        print_line("  storey %zu at %s m (%s to %s)  %s m²", i, fixed(storey.main_height, 1).c_str(),
                   fixed(storey.low, 2).c_str(), fixed(storey.high, 2).c_str(),
                   fixed(storey.area, 1).c_str());
    }
    if (const double low = report.space.low_area(); low > 0.0) {
        print_line("  of that crouching only  %s m²", fixed(low, 1).c_str());
    }
    for (const engine::Bound bound : report.space.bounds) {
        print_line("  incomplete: %s", text_of(bound));
    }
}

/// The first few of a kind that aren't reached.
void print_unreached(const WalkReport& report, SubjectKind kind, const char* what) {
    std::vector<std::string> names;
    for (const engine::SubjectReport& entry : report.subjects) {
        if (entry.subject.kind == kind && !entry.subject.reached) {
            names.push_back(entry.subject.name);
        }
    }
    if (!names.empty()) {
        print_line("  nobody %s %s", what, first_of(names).c_str());
    }
}

void print_popups(const scene::Campus& campus, const WalkReport& report) {
    const std::vector<BuildingPopup> popups = building_popups(campus, report);
    if (!popups.empty()) {
        print_line("pop-ups    %td of %zu that somebody can open",
                   std::ranges::count(popups, true, &BuildingPopup::opens), popups.size());
    }
}

/// What being reached means for this kind, if that isn't plain.
std::string remark(const WalkReport& report, SubjectKind kind) {
    if (kind == SubjectKind::building) {
        return " touched or seen, not necessarily entered";
    }
    if (kind == SubjectKind::door) {
        const auto through = std::ranges::count_if(
            report.subjects, [](const engine::SubjectReport& entry) { return entry.subject.walked_through; });
        return " that somebody gets to, " + std::to_string(through) + " walked through";
    }
    return "";
}

/// Spawns that no path joins with those with the most ground.
void print_separate(const scene::Campus& campus, const WalkReport& report) {
    const auto largest = std::ranges::max_element(report.separate, {}, &engine::SeparateGround::area);
    for (auto ground = report.separate.begin(); ground != report.separate.end(); ++ground) {
        if (ground != largest) {
            std::vector<std::string> names;
            for (const std::uint32_t start : ground->starts) {
                names.push_back(name_of_start(campus, report, report.space.starts[start]));
            }
            print_line("  nobody gets from %s, on %s m², to the other spawns or back",
                       first_of(names).c_str(), fixed(ground->area, 1).c_str());
        }
    }
}

/// How many of each kind are reached.
void print_subjects(const scene::Campus& campus, const WalkReport& report) {
    constexpr std::array kKinds{SubjectKind::spawn, SubjectKind::place,   SubjectKind::building,
                                SubjectKind::door,  SubjectKind::trigger, SubjectKind::ray,
                                SubjectKind::solid};
    constexpr std::array kPlurals{"spawns", "places", "buildings", "doors", "triggers", "rays", "solids"};
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
        std::size_t all = 0;
        std::size_t reached = 0;
        for (const engine::SubjectReport& entry : report.subjects) {
            all += entry.subject.kind == kKinds[k] ? 1U : 0U;
            reached += entry.subject.kind == kKinds[k] && entry.subject.reached ? 1U : 0U;
        }
        if (all > 0) {
            print_line("%-10s %zu of %zu%s", kPlurals[k], reached, all, remark(report, kKinds[k]).c_str());
        }
        if (all > 0 && kKinds[k] == SubjectKind::spawn) {
            print_separate(campus, report);
        }
        if (all > 0 && kKinds[k] == SubjectKind::building) {
            print_popups(campus, report);
        }
        if (kKinds[k] == SubjectKind::door) {
            print_unreached(report, kKinds[k], "gets to");
        }
    }
    print_unreached(report, SubjectKind::solid, "touches");
}

/// How far one walks to each place.
void print_distances(const scene::Campus& campus, const WalkReport& report) {
    struct Distance {
        std::string to;
        double metres = 0.0;
        std::string from;
    };
    std::vector<Distance> distances;
    for (const engine::SubjectReport& entry : report.subjects) {
        if (entry.subject.kind == SubjectKind::place && entry.distance) {
            distances.push_back({entry.subject.name, *entry.distance, start_of(campus, report, entry)});
        }
    }
    if (distances.empty()) {
        return;
    }
    const std::string& from = distances.front().from;
    const bool same = std::ranges::all_of(distances, [&](const Distance& d) { return d.from == from; });
    print_line("ways%s%s", same ? " from " : "", same ? from.c_str() : "");
    for (const Distance& d : distances) {
        print_line("  %-28s %8s m%s%s", d.to.c_str(), fixed(d.metres, 1).c_str(), same ? "" : " from ",
                   same ? "" : d.from.c_str());
    }
}

/// Where it is, unless its text says so, as what was measured does.
std::string where_text(const Finding& finding) {
    const std::string at = finding.at ? engine::coordinates_text(*finding.at) : "";
    if (finding.text.find(at) != std::string::npos) {
        return "";
    }
    return (finding.count > 1 ? ", the first at " : " at ") + at;
}

/// In one line: unreached ground that is no finding.
template <typename IsCounted>
void print_other_ground(const WalkReport& report, const char* what, const IsCounted& is_counted) {
    std::size_t count = 0;
    double area = 0.0;
    collision::Vec3 largest = collision::Vec3::Zero();
    for (const engine::IslandReport& entry : report.islands) {  // the largest first
        const double own = entry.island.area(report.space.grid);
        if (own > engine::kNotableIsland && is_counted(entry)) {
            largest = count++ == 0 ? entry.island.spots.front().at.foot : largest;
            area += own;
        }
    }
    if (count > 0) {
        print_line("%s: %zu, %s m² in all, the largest at %s", what, count, fixed(area, 0).c_str(),
                   engine::coordinates_text(largest).c_str());
    }
}

/// Narrow passages that are no findings, as there is a wider way.
void print_bypassed(const scene::Campus& campus, const WalkReport& report) {
    std::size_t count = 0;
    const engine::Bottleneck* narrowest = nullptr;
    for (const engine::Bottleneck& bottleneck : report.bottlenecks) {  // the narrowest first
        if (!bottleneck.is_only_path && count++ == 0) {
            narrowest = &bottleneck;
        }
    }
    if (narrowest != nullptr) {
        print_line("narrow passages that one may go round by a wider way: %zu, the narrowest %s, at %s",
                   count, bottleneck_text(campus, *narrowest).c_str(),
                   engine::coordinates_text(narrowest->passage.foot).c_str());
    }
}

}  // namespace

std::string first_of(const std::vector<std::string>& words) {
    constexpr std::size_t kMost = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(words.size(), kMost); ++i) {
        text.append(i == 0 ? "" : ", ").append(words[i]);
    }
    return words.size() > kMost ? text + " and " + std::to_string(words.size() - kMost) + " more" : text;
}

void print_report(const scene::Campus& campus, const WalkReport& report, const engine::AvatarProfile& avatar,
                  const std::vector<Finding>& findings) {
    print_line("# walk space of %s: radius %s m, height %s m, steps %s m, slopes up to %s degrees, %s m/s",
               campus.description.name.c_str(), fixed(avatar.radius, 2).c_str(),
               fixed(avatar.height, 2).c_str(), fixed(avatar.step_height, 2).c_str(),
               fixed(engine::degrees(avatar.max_slope), 1).c_str(), fixed(avatar.speed, 2).c_str());
    print_reached(report);
    print_subjects(campus, report);
    print_line("findings   %zu", findings.size());
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& f = findings[i];
        print_line("%4zu  %s%s: %s", i + 1, f.subject.c_str(), where_text(f).c_str(), f.text.c_str());
    }
    print_other_ground(report, "hollows inside solids",
                       [](const engine::IslandReport& entry) { return entry.hollow; });
    print_other_ground(
        report, "roofs and other tops that nobody climbs",
        [](const engine::IslandReport& entry) { return !entry.hollow && entry.barrier && is_top(entry); });
    print_other_ground(report, "ground and roofs that nothing which is reached lies near",
                       [](const engine::IslandReport& entry) { return !entry.hollow && !entry.barrier; });
    print_bypassed(campus, report);
    print_distances(campus, report);
}

void print_coverage(const WalkReport& report, const Coverage& coverage) {
    print_line(
        "coverage   %s %% of the ground (%s m²) by %zu walk%s%s", fixed(100.0 * coverage.share, 1).c_str(),
        fixed(coverage.area, 1).c_str(), coverage.walks, coverage.walks == 1 ? "" : "s",
        coverage.failed == 0
            ? ""
            : (", of which " + std::to_string(coverage.failed) + (coverage.failed == 1 ? " fails" : " fail"))
                  .c_str());
    for (const SubjectKind kind : {SubjectKind::building, SubjectKind::trigger}) {
        std::size_t reached = 0;
        std::size_t visited = 0;
        std::string missed;
        for (std::size_t i = 0; i < report.subjects.size(); ++i) {
            const engine::Subject& subject = report.subjects[i].subject;
            if (subject.kind != kind || !subject.reached) {
                continue;
            }
            ++reached;
            if (coverage.visited[i]) {
                ++visited;
            } else {
                missed += (missed.empty() ? "" : ", ") + subject.name;
            }
        }
        if (reached > 0) {
            print_line("  %ss %zu of %zu%s", engine::name_of(kind), visited, reached,
                       missed.empty() ? "" : ("; not " + missed).c_str());
        }
    }
}

}  // namespace campuswalk::tools::explore
