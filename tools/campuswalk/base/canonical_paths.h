#pragma once

#include <filesystem>
#include <map>

namespace campuswalk::tools {

/// Canonical paths of many files in few folders: each folder is followed to the end of its links once,
/// instead of a dozen system calls for each file.
class CanonicalPaths {
public:
    /// As std::filesystem::weakly_canonical of its absolute path: the file need not exist.
    std::filesystem::path of(const std::filesystem::path& file);

private:
    std::map<std::filesystem::path, std::filesystem::path> folders_;  ///< canonical, by how they are written
};

}  // namespace campuswalk::tools
