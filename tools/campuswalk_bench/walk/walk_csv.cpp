#include "tools/campuswalk_bench/walk/walk_csv.h"

#include <string>

#include "engine/events/decimals.h"
#include "scene/base/atomic_file.h"

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
    std::string text =
        "triangles,controller,us_mean,us_p50,us_p99,us_max,goals,reached,forbidden,max_penetration_mm,"
        "crossings\n";
    for (const WalkedCampus& campus : campuses) {
        for (const WalkScore& score : campus.scores) {
            text += line(campus.triangles, score);
        }
    }
    scene::write_file_atomically(file, text);
}

}  // namespace campuswalk::tools::bench
