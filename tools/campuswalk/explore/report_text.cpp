#include "tools/campuswalk/explore/report_text.h"

#include <array>
#include <string>

#include "engine/events/decimals.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

using engine::fixed;
using engine::SubjectKind;
using engine::WalkReport;

namespace {

const char* text_of(engine::Bound bound) {
    switch (bound) {
        case engine::Bound::nodes:
            return "the most nodes that are kept were reached";
        case engine::Bound::levels:
            return "there were more levels above one another than are kept";
        case engine::Bound::falls:
            return "a fall took longer than half a minute";
        case engine::Bound::steering:
            return "in falls of over half a metre, some ways to steer were tried, not all";
    }
    return "";
}

void print_reached(const WalkReport& report) {
    print_line("reached    %s m²", fixed(report.space.area(), 1).c_str());
    for (std::size_t i = 0; i < report.storeys.list.size() && report.storeys.list.size() > 1; ++i) {
        const engine::Storey& storey = report.storeys.list[i];
        print_line("  storey %zu at %s m (%s to %s)  %s m²", i, fixed(storey.main_height, 1).c_str(),
                   fixed(storey.low, 2).c_str(), fixed(storey.high, 2).c_str(),
                   fixed(storey.area, 1).c_str());
    }
    for (const engine::Bound bound : report.space.bounds) {
        print_line("  incomplete: %s", text_of(bound));
    }
}

/// Solids that no stride touches and that carry no one: the first few.
void print_untouched(const WalkReport& report) {
    constexpr std::size_t kMost = 8;
    std::string names;
    std::size_t count = 0;
    for (const engine::SubjectReport& entry : report.subjects) {
        if (entry.subject.kind == SubjectKind::solid && !entry.subject.reached && count++ < kMost) {
            names += (names.empty() ? "" : ", ") + entry.subject.name;
        }
    }
    if (count > 0) {
        print_line("  nobody touches %s%s", names.c_str(),
                   count > kMost ? (" and " + std::to_string(count - kMost) + " more").c_str() : "");
    }
}

/// How many of each kind are reached, and the way to each place.
void print_subjects(const WalkReport& report) {
    constexpr std::array kKinds{SubjectKind::spawn,   SubjectKind::place, SubjectKind::building,
                                SubjectKind::trigger, SubjectKind::ray,   SubjectKind::solid};
    constexpr std::array kPlurals{"spawns", "places", "buildings", "triggers", "rays", "solids"};
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
        std::size_t all = 0;
        std::size_t reached = 0;
        for (const engine::SubjectReport& entry : report.subjects) {
            all += entry.subject.kind == kKinds[k] ? 1U : 0U;
            reached += entry.subject.kind == kKinds[k] && entry.subject.reached ? 1U : 0U;
        }
        if (all > 0) {
            print_line("%-10s %zu of %zu", kPlurals[k], reached, all);
        }
        for (const engine::SubjectReport& entry : report.subjects) {
            if (kKinds[k] == SubjectKind::place && entry.subject.kind == kKinds[k] && entry.distance) {
                print_line("  %-28s %8s m", entry.subject.name.c_str(), fixed(*entry.distance, 1).c_str());
            }
        }
    }
    print_untouched(report);
}

void print_tops(const WalkReport& report) {
    std::size_t count = 0;
    double largest = 0.0;
    double area = 0.0;
    for (const engine::IslandReport& entry : report.islands) {
        const double own = entry.island.area(report.space.grid);
        if (own > engine::kNotableIsland && explore::is_top(entry)) {
            ++count;
            area += own;
            largest = std::max(largest, own);
        }
    }
    if (count > 0) {
        print_line("roofs and other tops that nobody climbs: %zu, %s m², the largest %s m²", count,
                   fixed(area, 0).c_str(), fixed(largest, 0).c_str());
    }
}

}  // namespace

void print_report(const scene::Campus& campus, const WalkReport& report, const engine::AvatarProfile& avatar,
                  const std::vector<Finding>& findings) {
    print_line("# walk space of %s: radius %s m, height %s m, steps %s m, slopes up to %s degrees, %s m/s",
               campus.description.name.c_str(), fixed(avatar.radius, 2).c_str(),
               fixed(avatar.height, 2).c_str(), fixed(avatar.step_height, 2).c_str(),
               fixed(engine::degrees(avatar.max_slope), 1).c_str(), fixed(avatar.speed, 2).c_str());
    print_reached(report);
    print_subjects(report);
    print_line("findings   %zu", findings.size());
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const Finding& f = findings[i];
        print_line("%4zu  %s: %s (%s, %s, %s)", i + 1, f.subject.c_str(), f.text.c_str(),
                   fixed(f.at.x(), 2).c_str(), fixed(f.at.y(), 2).c_str(), fixed(f.at.z(), 2).c_str());
    }
    print_tops(report);
}

void print_coverage(const WalkReport& report, const Coverage& coverage) {
    print_line(
        "coverage   %s %% of the ground (%s m²) by %zu walk%s%s", fixed(100.0 * coverage.share, 1).c_str(),
        fixed(coverage.area, 1).c_str(), coverage.walks, coverage.walks == 1 ? "" : "s",
        coverage.failed == 0 ? "" : (", of which " + std::to_string(coverage.failed) + " fail").c_str());
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
