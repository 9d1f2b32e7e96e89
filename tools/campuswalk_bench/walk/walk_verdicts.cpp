#include "tools/campuswalk_bench/walk/walk_verdicts.h"

#include <algorithm>

namespace campuswalk::tools::bench {

namespace {

constexpr double kAllowedPenetration = 1e-4;  ///< metres

void add_quality_verdicts(const std::vector<WalkedCampus>& campuses, std::vector<Verdict>& verdicts) {
    WalkScore all;
    for (const WalkedCampus& campus : campuses) {
        const WalkScore& ours = campus.scores.front();
        all.goals += ours.goals;
        all.reached += ours.reached;
        all.forbidden_reached += ours.forbidden_reached;
        all.crossings += ours.crossings;
        all.differing_paths += ours.differing_paths;
        if (ours.heap_growth) {
            all.heap_growth = all.heap_growth.value_or(0) + *ours.heap_growth;
        }
        all.us_max = std::max(all.us_max, ours.us_max);
        all.max_penetration = std::max(all.max_penetration, ours.max_penetration);
    }
    const auto count = [](std::size_t n) { return static_cast<double>(n); };
    verdicts.push_back(at_most("waypoints missed", count(all.goals - all.reached), "", 0.0));
    verdicts.push_back(at_most("forbidden goals reached", count(all.forbidden_reached), "", 0.0));
    verdicts.push_back(
        at_most("deepest penetration", 1000.0 * all.max_penetration, " mm", 1000.0 * kAllowedPenetration));
    verdicts.push_back(at_most("triangles crossed", count(all.crossings), "", 0.0));
    verdicts.push_back(at_most("paths that differ when repeated", count(all.differing_paths), "", 0.0));
    const auto growth = all.heap_growth ? std::optional(count(*all.heap_growth)) : std::nullopt;
    verdicts.push_back(at_most("heap growth in warm ticks", growth, " bytes", 0.0));
    verdicts.push_back(at_most("worst tick", all.us_max, " us", 20.0));
}

/// The growth from the smallest campus to the largest.
void add_growth_verdicts(const WalkedCampus& small, const WalkedCampus& large,
                         std::vector<Verdict>& verdicts) {
    verdicts.push_back(at_most(
        "growth of working memory",
        static_cast<double>(large.working_memory) / static_cast<double>(small.working_memory), "x", 1.2));
    const double mean = large.scores.front().us_mean;
    Verdict growth = at_most("growth of the mean tick", mean / small.scores.front().us_mean, "x", 2.5);
    if (large.fastest_peer && mean * 60.0 <= *large.fastest_peer) {
        growth.what += " (at 1/60 of Bullet's)";
        growth.holds = true;
    }
    verdicts.push_back(growth);
}

}  // namespace

bool is_correct(const WalkScore& ours) {
    return ours.reached == ours.goals && ours.forbidden_reached == 0 && ours.crossings == 0 &&
           ours.differing_paths == 0 && ours.max_penetration <= kAllowedPenetration;
}

std::vector<Verdict> walk_verdicts(const std::vector<WalkedCampus>& campuses, std::optional<double> tour_ms) {
    std::vector<Verdict> verdicts;
    for (const WalkedCampus& campus : campuses) {
        const auto ratio = campus.fastest_peer
                               ? std::optional(*campus.fastest_peer / campus.scores.front().us_mean)
                               : std::nullopt;
        verdicts.push_back(at_least("mean tick, " + std::to_string(campus.triangles) + " triangles", ratio,
                                    "x Bullet's", 40.0, 100.0));
    }
    add_quality_verdicts(campuses, verdicts);
    if (campuses.size() > 1) {
        add_growth_verdicts(campuses.front(), campuses.back(), verdicts);
    }
    verdicts.push_back(at_most("two minutes of the demo tour", tour_ms, " ms", 50.0));
    return verdicts;
}

}  // namespace campuswalk::tools::bench
