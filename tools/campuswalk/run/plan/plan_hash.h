#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "config/loader/load_run.h"
#include "engine/report/walk_result.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::tools {

/// Identifies the cases of a run by their names and by the contents of the YAML files that they consist of.
class PlanContents {
public:
    /// `run` is null for a walk with errors: then only its own file is included.
    void add(const engine::WalkResult& planned, const config::SharedRun* run);
    std::string hash() const { return to_string(hasher_.result()); }

private:
    void add_file(const std::filesystem::path& file);

    scene::ContentHasher hasher_;
    std::map<std::filesystem::path, scene::ContentHash> known_;  ///< hashes of files
};

/// Identifies which case is in which shard.
class Division {
public:
    /// In the order of the shards and, in each, of its cases. `shard` counts from 1.
    void add(int shard, std::string_view case_id);
    std::string hash() const { return to_string(hasher_.result()); }

private:
    scene::ContentHasher hasher_;
};

}  // namespace campuswalk::tools
