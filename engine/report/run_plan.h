#pragma once

#include <cstddef>
#include <string>

namespace campuswalk::engine {

/// What a run, or one shard of it, sets out to do. Reports carry it, so that a reader can tell whether every
/// case was evaluated. The fields from `shards` on are the same for all shards of a run.
struct RunPlan {
    std::size_t cases = 0;  ///< of this shard
    int shard = 1;          ///< from 1
    int shards = 1;
    std::size_t all_cases = 0;  ///< of all shards
    std::string contents = {};  ///< hash of all cases and of the YAML files that they name
    std::string division = {};  ///< hash of which case is in which shard
    std::string start = {};     ///< where it was started, as seen from the repository's root
};

}  // namespace campuswalk::engine
