#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk/run/results/result_file.h"

namespace campuswalk::tools {

/// What a shard's job has left, in a folder of its own whose name ends in the shard's number: `campuswalk-3`
/// with `results-3.jsonl` and the files that these results name.
struct ShardArtifact {
    std::filesystem::path folder;
    ResultFile results;
};

/// The artifacts in a folder, as CI services hand them to a later job, by their numbers. Results of a shard
/// are taken from its own artifact only: whatever else is in an artifact isn't read. Other folders are left
/// out. A key as in ResultFile::open. Throws scene::InputError:
///   missing-file     the folder isn't there, or has no artifact
///   bad-report       the results of an artifact aren't a report
///   foreign-results  they are another shard's, or weren't signed with the key
std::vector<ShardArtifact> open_shard_artifacts(const std::filesystem::path& folder,
                                                const std::optional<std::string>& key);

/// Copies the files that results name, and the bundles of campuses, from each shard's artifact into `output`;
/// no other file, and none through a link. Returns how many of them aren't there. Throws scene::InputError
/// (foreign-results), before anything is copied, when two shards have different files of one name or a walk
/// names a file that isn't in a folder.
std::size_t gather_files(const std::vector<ShardArtifact>& artifacts, const std::filesystem::path& output);

}  // namespace campuswalk::tools
