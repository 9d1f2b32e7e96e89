#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/walk/walk_case.h"

namespace campuswalk::tools::bench {

/// triangles,controller,us_mean,us_p50,us_p99,us_max,goals,reached,forbidden,max_penetration_mm,crossings:
/// one line per campus and controller. `goals` are the allowed ones, `reached` counts those that were
/// reached, and `forbidden` the forbidden goals that were. `bullet` is the better of `bullet_default` and
/// `bullet_tuned`. Throws std::runtime_error.
void write_walk_csv(const std::vector<WalkedCampus>& campuses, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench
