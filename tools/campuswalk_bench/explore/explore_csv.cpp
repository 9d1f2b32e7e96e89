#include "tools/campuswalk_bench/explore/explore_csv.h"

#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "engine/events/decimals.h"

namespace campuswalk::tools::bench {

namespace {

/// Pairs that each arrives in, times of a query, and how long our routes are beside the peer's.
std::string routes_text(const std::optional<RouteScore>& routes, bool ours) {
    if (!routes || (!ours && !routes->peer)) {
        return ",,,";
    }
    const QueryTimes& times = ours ? routes->ours : *routes->peer;
    return std::to_string(ours ? routes->found + routes->found_else : routes->by_peer) + ',' +
           engine::fixed(times.median, 1) + ',' + engine::fixed(times.p99, 1) + ',' +
           (ours && routes->length_ratio ? engine::fixed(*routes->length_ratio, 4) : "");
}

std::string line(const ExploreScore& score, const ExploreTime& time) {
    const bool ours = time.engine == "ours";
    std::string text = score.campus + ',' + std::to_string(score.triangles) + ',' + time.engine + ',' +
                       std::to_string(time.threads) + ',' + engine::fixed(time.least, 4) + ',' +
                       engine::fixed(time.median, 4) + ',' + engine::fixed(time.processor, 4) + ',';
    if (ours) {
        text += engine::fixed(score.area, 1) + ',' + std::to_string(score.nodes) + ',' +
                std::to_string(score.ticks) + ',' +
                (score.bytes_per_area ? engine::fixed(*score.bytes_per_area, 1) : "") + ',' +
                (score.disagreement ? engine::fixed(score.disagreement->only_ours.area, 1) : "") + ',' +
                std::to_string(score.adversary.escapes.size()) + ',' +
                std::to_string(score.steered.escapes.size());
    } else if (time.engine == "report") {
        return text + ",,,,,,,,,,\n";
    } else {
        text += engine::fixed(score.disagreement->polygon_area, 1) + ",,,," +
                engine::fixed(score.disagreement->only_peer.area, 1) + ",,";
    }
    return text + ',' + routes_text(score.routes, ours) + '\n';
}

}  // namespace

void write_explore_csv(const std::vector<ExploreScore>& scores, const std::filesystem::path& file) {
    if (file.has_parent_path()) {
        std::filesystem::create_directories(file.parent_path());
    }
    std::ofstream out(file, std::ios::binary);
    out << "campus,triangles,engine,threads,s_least,s_median,s_processor,reachable_m2,nodes,ticks,bytes_per_"
           "m2,"
           "m2_of_it_alone,walks_outside,steered_walks_outside,routes,us_route_median,us_route_p99,"
           "route_length_ratio\n";
    for (const ExploreScore& score : scores) {
        for (const ExploreTime& time : score.times) {
            out << line(score, time);
        }
    }
    out.close();
    if (!out) {
        throw std::runtime_error("'" + file.string() + "' couldn't be written");
    }
}

}  // namespace campuswalk::tools::bench
