#pragma once

#include <filesystem>

namespace campuswalk::tools::bench {

/// Walks on campuses of about 60 thousand, half a million and 2 million triangles, or on a small one if
/// `quick`, and prints scores and verdicts. `csv` may be empty. False if our mover did anything wrong,
/// whatever its speed.
bool run_walk_bench(int rounds, bool quick, const std::filesystem::path& csv);

}  // namespace campuswalk::tools::bench
