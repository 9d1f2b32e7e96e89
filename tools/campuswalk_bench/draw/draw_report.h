#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/draw/draw_times.h"

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

/// One target of drawing, and what was measured.
struct DrawVerdict {
    std::string what;
    std::optional<double> value;  ///< none when it wasn't measured
    const char* unit = "";
    bool more_is_better = false;
    double must = 0.0;
    std::optional<double> aim;

    bool holds() const { return value && (more_is_better ? *value >= must : *value <= must); }
};

/// Milliseconds and ratios are of medians. Memory is the difference between the last campus and the first:
/// textures, shadow maps and the image's own buffers are the same for both.
std::vector<DrawVerdict> draw_verdicts(const std::vector<DrawnCampus>& campuses);
void print_draw_verdicts(const std::vector<DrawVerdict>& verdicts);

/// One line per campus, engine and look. Throws std::runtime_error when it can't be written.
void write_draw_csv(const std::vector<DrawnCampus>& campuses, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench
