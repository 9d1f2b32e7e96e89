#pragma once

#include <filesystem>

namespace campuswalk::tools {

/// The files of work on a cluster, below the output folder: all machines see them.
struct JobFolder {
    std::filesystem::path root;

    std::filesystem::path plan() const { return root / "plan.jsonl"; }         ///< header of a jsonl report
    std::filesystem::path times() const { return root / "times.jsonl"; }       ///< see case_times.h
    std::filesystem::path job() const { return root / "job"; }                 ///< numbers of Slurm's jobs
    std::filesystem::path shard_script() const { return root / "shard.sh"; }   ///< of the array's tasks
    std::filesystem::path merge_script() const { return root / "merge.sh"; }   ///< of the job after them
    std::filesystem::path results() const { return root / "results"; }         ///< N.jsonl of each shard
    std::filesystem::path saved() const { return root / "saved"; }             ///< N.jsonl to resume it from
    std::filesystem::path ended() const { return root / "ended"; }             ///< N with its exit code
    std::filesystem::path logs() const { return root / "logs"; }               ///< N.txt: what it printed
    std::filesystem::path merged() const { return root / "merged"; }           ///< the merge's exit code
    std::filesystem::path merge_output() const { return root / "merge.txt"; }  ///< what it printed
    std::filesystem::path merge_errors() const { return root / "merge-errors.txt"; }
};

/// Of a run with this output folder.
inline JobFolder job_folder(const std::filesystem::path& output) {
    return {output / "slurm"};
}

}  // namespace campuswalk::tools
