#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace campuswalk::tools {

/// The shard of each item, from 0. Items whose times are known go to the shard that has least to do so far,
/// the longest item first (Graham's rule LPT: at most 4/3 - 1/(3·shards) of the shortest time that is
/// possible); ties go to the earlier item and to the earlier shard. An unknown time is taken for the mean of
/// the known ones. If none is known, the shards are consecutive parts, as slice_of() says.
///
/// R. L. Graham, "Bounds on Multiprocessing Timing Anomalies", SIAM J. Appl. Math. 17 (1969).
std::vector<int> balanced(const std::vector<std::optional<std::uint64_t>>& times, int shards);

}  // namespace campuswalk::tools
