#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "config/loader/load_run.h"
#include "engine/report/walk_result.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::tools {

/// Hashes of files, each read once. All zero for one that can't be read.
class FileHashes {
public:
    const scene::ContentHash& of(const std::filesystem::path& file);

private:
    std::map<std::filesystem::path, scene::ContentHash> known_;
};

/// Identifies the cases of a run by their names, by the contents of the YAML files that they consist of, and
/// by what the command line changes about them: limits of time and the kind of trees.
class PlanContents {
public:
    /// `run` is null for a walk with errors: then only its own file is included.
    void add(const engine::WalkResult& planned, const config::Run* run);
    std::string hash() const { return to_string(hasher_.result()); }

private:
    scene::ContentHasher hasher_;
    FileHashes files_;
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
