#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/measure/verdict.h"

namespace campuswalk::tools::bench {

/// The times of all images of one campus.
struct DrawnCampus {
    std::string name;  ///< of its kind: "hills", "houses"
    std::size_t triangles = 0;
    std::vector<DrawTimes> looks;  ///< ours first
    double encode_ms = 0.0;
    std::size_t heap_bytes = 0;
};

void print_draw_table(const DrawnCampus& campus);

/// Milliseconds and ratios are of medians. Memory is the difference between the last campus and the first:
/// textures, shadow maps and the image's own buffers are the same for both.
std::vector<Verdict> draw_verdicts(const std::vector<DrawnCampus>& campuses);
void print_draw_verdicts(const std::vector<Verdict>& verdicts);

/// One line per campus, engine and look. Throws std::runtime_error when it can't be written.
void write_draw_csv(const std::vector<DrawnCampus>& campuses, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench
