#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "tools/campuswalk/base/environment.h"

namespace campuswalk::tools {

/// One of several parts of a run, each on a machine of its own.
struct Shard {
    int index = 0;  ///< from 0
    int count = 1;
    std::string from;         ///< the option or variable that sets it
    std::string status_file;  ///< to be touched to show that sharding is supported; empty for none
};

/// `i/n` with i from 1 to n; nullopt for anything else.
std::optional<Shard> parse_shard(const std::string& text);

/// From the variables of the first of these that are set:
///   campuswalk  CAMPUSWALK_SHARD_INDEX, from 0, and CAMPUSWALK_SHARD_COUNT
///   Bazel       TEST_SHARD_INDEX, from 0, TEST_TOTAL_SHARDS and TEST_SHARD_STATUS_FILE
///   Slurm       SLURM_ARRAY_TASK_ID from _MIN on in steps of _STEP, SLURM_ARRAY_TASK_COUNT
///   Kubernetes  JOB_COMPLETION_INDEX, from 0, and CAMPUSWALK_SHARD_COUNT
/// Throws scene::InputError (bad-shard) when they make no sense.
std::optional<Shard> shard_from(const Environment& environment);

/// The shard's part of `total` items: [first, last). The parts of all shards are contiguous and differ in
/// size by one at most.
struct Slice {
    std::size_t first = 0;
    std::size_t last = 0;
};
Slice slice_of(std::size_t total, const Shard& shard);

}  // namespace campuswalk::tools
