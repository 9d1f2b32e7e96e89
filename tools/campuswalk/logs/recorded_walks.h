#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// A walk that was run, as a log or a report has kept it.
struct RecordedWalk {
    std::string name;
    std::string project;
    std::filesystem::path config;       ///< the walks.config.yaml with the project; empty when it isn't told
    std::filesystem::path file;         ///< its walk file
    std::optional<double> timeout;      ///< simulated seconds
    std::optional<std::uint64_t> hash;  ///< none when it didn't come to its end
    std::string why_none;               ///< "skipped", "interrupted", …
    std::size_t line = 0;               ///< where it stands, from 1
};

/// The walks of `lines`, a log or a report of JSON lines read from `source`. A log doesn't say where its
/// walks' files are: they are among `walk_files`. Throws scene::InputError with the line that can't be used.
std::vector<RecordedWalk> recorded_walks(const std::filesystem::path& source,
                                         const std::vector<std::string>& lines,
                                         const std::vector<std::filesystem::path>& walk_files);

}  // namespace campuswalk::tools
