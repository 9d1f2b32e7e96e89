#pragma once

#include <filesystem>
#include <memory>

#include "engine/html_report/html_reporter.h"

namespace campuswalk::tools {

/// The results of a jsonl report (or of a folder of shards' reports), to compare another run with. `output`
/// is where the walks' files are. Keeps where each result is, not the results. Throws scene::InputError for a
/// file that isn't one.
engine::ComparedRun open_compared_run(const std::filesystem::path& input,
                                      const std::filesystem::path& output);

}  // namespace campuswalk::tools
