#pragma once

#include <cstddef>
#include <string>

namespace campuswalk::engine {

/// What the results of a run depend on, apart from what its shards may differ in: their number, the output
/// folder, the reports and the number of workers. Three parts, so that a reader can say which one differs.
struct RunFingerprint {
    std::string program = {};  ///< version
    std::string options = {};  ///< hash of the options, strictness among them
    std::string files = {};    ///< hash of campuses, models, textures, lists of places and golden files

    bool operator==(const RunFingerprint&) const = default;
};

/// What a run, or one shard of it, sets out to do. Reports carry it, so that a reader can tell whether every
/// case was evaluated. The fields from `shards` on are the same for all shards of a run.
struct RunPlan {
    std::size_t cases = 0;  ///< of this shard
    int shard = 1;          ///< from 1
    int shards = 1;
    std::size_t all_cases = 0;  ///< of all shards
    std::string contents = {};  ///< hash of all cases and of the YAML files that they name
    std::string division = {};  ///< hash of which case is in which shard
    RunFingerprint fingerprint = {};
    std::string start = {};  ///< where it was started, as seen from the repository's root
};

}  // namespace campuswalk::engine
