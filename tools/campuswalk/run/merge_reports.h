#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/campuswalk/run/run_options.h"

namespace campuswalk::tools {

struct MergeOptions {
    std::vector<std::filesystem::path> inputs;  ///< jsonl reports, or folders to look for them in
    std::vector<std::string> reporters;         ///< NAME or NAME=FILE; `list` if there are none
    std::filesystem::path output = "out";       ///< where the images are that reports name
    ColorChoice color = ColorChoice::automatic;
};

/// The reports of a run's shards as those of the run. Returns the exit code that the run would have had.
int merge_reports(const MergeOptions& options);

}  // namespace campuswalk::tools
