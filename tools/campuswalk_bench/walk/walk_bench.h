#pragma once

#include <filesystem>

namespace campuswalk::tools::bench {

/// Walks on campuses of about 60 thousand, half a million and 2 million triangles, or on a small one if
/// `quick`; prints how, and the verdicts. `csv` may be empty. False if our mover did anything wrong; slow
/// isn't wrong.
bool run_walk_bench(int rounds, bool quick, const std::filesystem::path& csv);

}  // namespace campuswalk::tools::bench
