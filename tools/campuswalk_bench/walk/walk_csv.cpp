#include "tools/campuswalk_bench/walk/walk_csv.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include "engine/events/decimals.h"

namespace campuswalk::tools::bench {

namespace {

std::string line(std::size_t triangles, const WalkScore& score) {
    std::string text = std::to_string(triangles) + ',' + score.controller;
    for (const double us : {score.us_mean, score.us_p50, score.us_p99, score.us_max}) {
        text += ',' + engine::fixed(us, 3);
    }
    for (const std::size_t count : {score.goals, score.reached, score.forbidden_reached}) {
        text += ',' + std::to_string(count);
    }
    return text + ',' + engine::fixed(1000.0 * score.max_penetration, 3) + ',' +
           std::to_string(score.crossings) + '\n';
}

}  // namespace

void write_walk_csv(const std::vector<WalkedCampus>& campuses, const std::filesystem::path& file) {
    if (file.has_parent_path()) {
        std::filesystem::create_directories(file.parent_path());
    }
    std::ofstream out(file, std::ios::binary);
    out << "triangles,controller,us_mean,us_p50,us_p99,us_max,goals,reached,forbidden,max_penetration_mm,"
           "crossings\n";
    for (const WalkedCampus& campus : campuses) {
        for (const WalkScore& score : campus.scores) {
            out << line(campus.triangles, score);
        }
    }
    out.close();
    if (!out) {
        throw std::runtime_error("'" + file.string() + "' couldn't be written");
    }
}

}  // namespace campuswalk::tools::bench
