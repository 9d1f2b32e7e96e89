#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// A walk that was run, as a log or a report records it.
struct RecordedWalk {
    std::string id;  ///< in a report
    std::string name;
    std::string project;
    std::filesystem::path config;       ///< the walks.config.yaml with the project; empty if unknown
    std::filesystem::path file;         ///< its walk file
    std::optional<double> timeout;      ///< simulated seconds
    std::optional<std::uint64_t> hash;  ///< nullopt if it didn't reach its end
    std::string why_no_hash;            ///< "skipped", "interrupted", …
    bool skipped = false;               ///< it wasn't to be run
    std::size_t line = 0;               ///< in the source, from 1
};

/// What a log or a report has recorded.
struct Recording {
    std::vector<RecordedWalk> walks;
    std::size_t missing = 0;  ///< walks that a report announces and doesn't have
};

/// The walks of `lines`, a log or a report in JSON lines that was read from `source`. A log doesn't say where
/// its walks' files are: they are looked up in `walk_files`. Throws scene::InputError with the line that
/// can't be used.
Recording recorded_walks(const std::filesystem::path& source, const std::vector<std::string>& lines,
                         const std::vector<std::filesystem::path>& walk_files);

}  // namespace campuswalk::tools
